package arcomat.pipeline.campaign.joint;

/** What is read at a moment is none of a port's values. */
final class ForeignValue extends Exception {
    private static final long serialVersionUID = 1L;

    ForeignValue(String message) {
        super(message);
    }
}

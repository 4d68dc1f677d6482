package arcomat.analysis.mona;

/** A question that is not put to MONA; the message says why. */
public final class NotForMona extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public NotForMona(String reason) {
        super(reason);
    }
}

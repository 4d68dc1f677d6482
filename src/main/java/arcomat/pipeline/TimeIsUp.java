package arcomat.pipeline;

/** Work was not done in the time that it had: what was asked is unknown. */
public final class TimeIsUp extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /**
     * @param work that was being done
     */
    TimeIsUp(String work) {
        super("the time is up while " + work);
    }
}

package arcomat.pipeline.campaign.engine;

/** An engine that cannot go on; its message tells people why, and what to do. */
public final class EngineFailure extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public EngineFailure(String message) {
        super(message);
    }
}

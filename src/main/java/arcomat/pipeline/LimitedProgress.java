package arcomat.pipeline;

/**
 * Work that has an end in time. What is found until then is still told, so a step may begin after
 * the end: it is for those to ask that cannot end with an answer of their own.
 */
public final class LimitedProgress implements Progress {
    private final Progress told;
    private final long end;
    private volatile String work = "starting";

    /**
     * @param told of what is done until then
     * @param end in the time of {@link System#nanoTime}
     */
    public LimitedProgress(Progress told, long end) {
        this.told = told;
        this.end = end;
    }

    @Override
    public void step(String what) {
        work = what;
        told.step(what);
    }

    @Override
    public void goOn() {
        if (System.nanoTime() - end >= 0) {
            throw new TimeIsUp(work);
        }
    }

    @Override
    public Progress unlimited() {
        return told;
    }
}

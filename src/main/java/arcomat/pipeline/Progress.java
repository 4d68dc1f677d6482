package arcomat.pipeline;

/** Told what the pipeline is about to do, so that long work can be seen to go on. */
public interface Progress {
    Progress NONE = what -> {};

    /**
     * @param what the work that begins, such as {@code parsing 300 files}
     */
    void step(String what);

    /**
     * Asked at every step of long work, by many threads.
     *
     * @throws TimeIsUp where nobody waits for it any longer
     */
    default void goOn() {}

    /** The same, for work whose end is not that of what is around it. */
    default Progress unlimited() {
        return this;
    }

    /** Work on a number of things: {@code parsing 1 file}; nothing is said about no things. */
    default void step(String work, int number, String noun) {
        if (number > 0) {
            step(work + " " + number + " " + noun + (number == 1 ? "" : "s"));
        }
    }
}

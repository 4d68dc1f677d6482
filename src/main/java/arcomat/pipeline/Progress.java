package arcomat.pipeline;

/** Told what the pipeline is about to do, so that long work can be seen to go on. */
public interface Progress {
    Progress NONE = what -> {};

    /**
     * @param what the work that begins, such as {@code parsing 300 files}
     */
    void step(String what);
}

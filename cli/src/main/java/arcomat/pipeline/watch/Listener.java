package arcomat.pipeline.watch;

import arcomat.pipeline.watch.WatchStatus.Step;

import java.util.Collection;

/** Is told what becomes of the models; never by two threads at once. */
public interface Listener {
    /**
     * Somebody has saved something, and it is looked at now.
     *
     * @param files as they are shown
     */
    void changed(Collection<String> files);

    /** A step has its answers. */
    void done(Done what, WatchStatus now);

    /** All steps have. */
    void settled(WatchStatus now);

    /**
     * What was done.
     *
     * @param subjects how many files were checked, suites and worlds run, promises shown
     * @param nanos from when the change was seen, for a check; from when it was begun, for others
     */
    record Done(Step step, int subjects, long nanos) {}
}

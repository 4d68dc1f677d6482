package arcomat.pipeline.brick;

import arcomat.sim.device.SilentObserver;

/** How long the longest slice took, in microseconds: from the end of one sleep to the next. */
final class SliceObserver extends ForwardingObserver {
    private long awake = -1;
    private long longest;

    SliceObserver() {
        super(new SilentObserver());
    }

    @Override
    public void slept(long from, long until) {
        if (awake >= 0) {
            longest = Math.max(longest, from - awake);
        }
        awake = until;
    }

    long longest() {
        return longest;
    }
}

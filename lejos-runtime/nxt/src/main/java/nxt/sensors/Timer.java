package nxt.sensors;

/**
 * Platform component nxt.Timer on the brick. It compares the clock with a deadline once per slice:
 * the timer of leJOS has a thread of its own, which goes on for ever.
 */
public final class Timer {
    private static final int SILENCE = 0;

    /** The one constant of nxt.Brick.Tick. */
    private static final int TICK = 1;

    /** Code of nxt.Brick.Tick; 0 for none. */
    public int signal;

    private final int period;
    private long next;

    public Timer(int period) {
        this.period = period;
        this.next = System.currentTimeMillis() + period;
    }

    /** Looks at the clock: the start of a slice. */
    public void sense() {
        long late = System.currentTimeMillis() - next;
        if (late < 0) {
            signal = SILENCE;
        } else {
            signal = TICK;
            next += (late / period + 1) * period;
        }
    }
}

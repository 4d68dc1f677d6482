package arcomat.sim.device;

import org.jspecify.annotations.Nullable;

/**
 * The rounds of a program's main loop: what its first thread does from one wait to the next. One
 * that takes longer than it should ends without a wait.
 */
public final class Slices {
    private final Hardware hardware;

    /** Microseconds since switching on. */
    private long begun;

    private @Nullable Object clock;
    private boolean waited;

    Slices(Hardware hardware) {
        this.hardware = hardware;
        this.begun = hardware.time().now();
    }

    /** A thread has slept for so long; for less than nothing, where it comes late. */
    void slept(long from, long milliseconds) {
        if (!hardware.lifetime().isMain()) {
            return;
        }
        if (milliseconds < 0) {
            late();
        } else {
            begun = hardware.time().now();
            hardware.observer().slept(from, begun);
        }
        waited = true;
    }

    /** The program asks the clock of its slices to wait for the next one. */
    public void await(Object newClock) {
        if (hardware.lifetime().isMain()) {
            // A clock never waits at first: that begins a slice and ends none.
            waited = newClock != clock;
            clock = newClock;
        }
    }

    /** The clock of its slices lets the program go on. */
    public void awaited() {
        if (hardware.lifetime().isMain() && !waited) {
            late();
        }
    }

    private void late() {
        long now = hardware.time().now();
        hardware.observer().late(begun, now);
        begun = now;
    }
}

package arcomat.sim.device;

import arcomat.sim.time.Timetable;
import arcomat.sim.time.VirtualTime;

/**
 * The buttons. As on the brick, programs see what is down, and what is up again, only when no
 * button has changed for a while.
 */
public final class Keypad {
    /** Pressed together, these two end any program. */
    private static final int ABORT = Key.ENTER.bit() | Key.ESCAPE.bit();

    private final VirtualTime time;
    private final long delay;
    private final Runnable abort;
    private final Timetable settling = new Settling();
    private int touched;
    private int down;

    Keypad(VirtualTime time, long delay, Runnable abort) {
        this.time = time;
        this.delay = delay;
        this.abort = abort;
        if (delay > 0) {
            time.start(settling, VirtualTime.NEVER);
        }
    }

    public void press(Key key) {
        touch(touched | key.bit());
    }

    public void release(Key key) {
        touch(touched & ~key.bit());
    }

    private void touch(int keys) {
        if (keys == touched) {
            return;
        }
        touched = keys;
        if (delay == 0) {
            settle();
        } else {
            time.restart(settling, time.now() + delay);
        }
    }

    private void settle() {
        int before = down;
        down = touched;
        if (down != before && (down & ABORT) == ABORT) {
            abort.run();
        }
    }

    private final class Settling extends Timetable {
        @Override
        protected long act() {
            settle();
            return VirtualTime.NEVER;
        }
    }

    /** The bits of the buttons that are down. */
    public int down() {
        return down;
    }
}

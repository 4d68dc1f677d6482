package arcomat.sim.device;

import arcomat.sim.time.Timetable;
import arcomat.sim.time.VirtualTime;

/** The buttons. As on the brick, a press is seen only when it has lasted for a while. */
public final class Keypad {
    /** Pressed together, these two end any program. */
    private static final int ABORT = Key.ENTER.bit() | Key.ESCAPE.bit();

    private static final Key[] KEYS = Key.values();

    private final VirtualTime time;
    private final long delay;
    private final Runnable abort;
    private final long[] pressed = new long[KEYS.length];
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
        if ((touched & key.bit()) != 0) {
            return;
        }
        touched |= key.bit();
        pressed[key.ordinal()] = time.now();
        if (delay == 0) {
            see(key);
        } else {
            time.restart(settling, nextSeen());
        }
    }

    public void release(Key key) {
        touched &= ~key.bit();
        down &= ~key.bit();
    }

    private void see(Key key) {
        down |= key.bit();
        if ((down & ABORT) == ABORT) {
            abort.run();
        }
    }

    /** When the next of the keys that are pressed and not yet seen will be. */
    private long nextSeen() {
        long next = VirtualTime.NEVER;
        for (Key key : KEYS) {
            if ((touched & ~down & key.bit()) != 0) {
                next = Math.min(next, pressed[key.ordinal()] + delay);
            }
        }
        return next;
    }

    private final class Settling extends Timetable {
        @Override
        protected long act() {
            for (Key key : KEYS) {
                boolean isNew = (touched & ~down & key.bit()) != 0;
                if (isNew && pressed[key.ordinal()] + delay <= time.now()) {
                    see(key);
                }
            }
            return nextSeen();
        }
    }

    /** The bits of the buttons that are down. */
    public int down() {
        return down;
    }
}

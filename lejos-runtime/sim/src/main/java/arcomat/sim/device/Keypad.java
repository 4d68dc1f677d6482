package arcomat.sim.device;

/** The buttons, and what happened to them since a program last asked. */
public final class Keypad {
    /** Pressed together, these two end any program. */
    private static final int ABORT = Key.ENTER.bit() | Key.ESCAPE.bit();

    /** Where the bits of releases begin among events. */
    private static final int RELEASES = 8;

    private final Runnable abort;
    private int down;
    private int events;

    Keypad(Runnable abort) {
        this.abort = abort;
    }

    public void press(Key key) {
        if ((down & key.bit()) != 0) {
            return;
        }
        down |= key.bit();
        events |= key.bit();
        if ((down & ABORT) == ABORT) {
            abort.run();
        }
    }

    public void release(Key key) {
        if ((down & key.bit()) != 0) {
            down &= ~key.bit();
            events |= key.bit() << RELEASES;
        }
    }

    /** The bits of the buttons that are down. */
    public int down() {
        return down;
    }

    /** Takes events of some buttons: bits of presses, and of releases eight places higher. */
    public int take(int mask) {
        int taken = events & mask;
        events &= ~mask;
        return taken;
    }
}

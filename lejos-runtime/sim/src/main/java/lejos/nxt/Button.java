package lejos.nxt;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.Key;

/** The four buttons. */
public class Button {
    public static final int ID_ENTER = 1;
    public static final int ID_LEFT = 2;
    public static final int ID_RIGHT = 4;
    public static final int ID_ESCAPE = 8;

    private static final Hardware BRICK = Hardware.of(Button.class);
    private static final int ALL = 0xf;
    private static final int RELEASES = 8;

    public static final Button ENTER = new Button(Key.ENTER);
    public static final Button LEFT = new Button(Key.LEFT);
    public static final Button RIGHT = new Button(Key.RIGHT);
    public static final Button ESCAPE = new Button(Key.ESCAPE);
    public static final Button[] BUTTONS = {ENTER, LEFT, RIGHT, ESCAPE};

    private final int id;

    private Button(Key key) {
        this.id = key.bit();
    }

    public final int getId() {
        return id;
    }

    public final boolean isDown() {
        return (readButtons() & id) != 0;
    }

    public final boolean isUp() {
        return !isDown();
    }

    public final boolean isPressed() {
        return isDown();
    }

    /** The bits of the buttons that are down. */
    public static int readButtons() {
        return BRICK.called().keypad().down();
    }

    public static void discardEvents() {
        BRICK.called().keypad().take(ALL | ALL << RELEASES);
    }

    public final void waitForPress() {
        await(id, 0);
    }

    public final void waitForPressAndRelease() {
        await(id, 0);
        await(id << RELEASES, 0);
    }

    public static int waitForAnyPress() {
        return waitForAnyPress(0);
    }

    /** The bits of the buttons pressed; 0 after so many milliseconds without, where 0 waits on. */
    public static int waitForAnyPress(int timeout) {
        return await(ALL, timeout);
    }

    /** Like {@link #waitForAnyPress(int)}; releases are bits eight places higher. */
    public static int waitForAnyEvent(int timeout) {
        return await(ALL | ALL << RELEASES, timeout);
    }

    private static int await(int mask, int timeout) {
        long end = timeout == 0 ? Long.MAX_VALUE : BRICK.milliseconds() + timeout;
        int events = BRICK.keypad().take(mask);
        while (events == 0 && BRICK.milliseconds() < end) {
            BRICK.time().waitUntil(BRICK.tickAfter(1));
            events = BRICK.keypad().take(mask);
        }
        return events;
    }
}

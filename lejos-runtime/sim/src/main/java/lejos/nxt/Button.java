package lejos.nxt;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.Key;

import java.util.Arrays;

/**
 * The four buttons. As on the brick, waiting compares what is down now with what was down when
 * somebody last waited: a tap in between leaves no trace, and waiting for one button forgets what
 * happened to the others. Key clicks are not simulated: their settings are only kept.
 */
public class Button implements ListenerCaller {
    public static final int ID_ENTER = 1;
    public static final int ID_LEFT = 2;
    public static final int ID_RIGHT = 4;
    public static final int ID_ESCAPE = 8;
    public static final String VOL_SETTING;

    private static final Hardware BRICK = Hardware.of(Button.class);
    private static final int RELEASES = 8;
    private static final int ROOM = 4;
    private static final int PERIOD = 10;
    private static final int USUAL_VOLUME = 20;
    private static final int USUAL_LENGTH = 50;

    /** Tones by the bits of the keys that are down together; 0 is silent. */
    private static final int[] USUAL_TONES = {
        0, 906, 979, 1403, 1061, 1485, 0, 0, 1150, 1574, 0, 0, 0, 0, 0, 0
    };

    public static final Button ENTER = new Button(Key.ENTER);
    public static final Button LEFT = new Button(Key.LEFT);
    public static final Button RIGHT = new Button(Key.RIGHT);
    public static final Button ESCAPE = new Button(Key.ESCAPE);
    public static final Button[] BUTTONS = {ENTER, LEFT, RIGHT, ESCAPE};

    private static int waited = BRICK.keypad().down();
    private static int clickVolume;
    private static int clickLength;
    private static int[] clickTones;

    static {
        VOL_SETTING = "lejos.keyclick_volume";
        loadSystemSettings();
    }

    private final int id;
    private ButtonListener[] listeners;
    private int count;
    private boolean wasDown;

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
        waited = readButtons();
    }

    public final void waitForPress() {
        int pressed = 0;
        while ((pressed & id) == 0) {
            pressed = waitForAnyPress(0);
        }
    }

    public final void waitForPressAndRelease() {
        waitForPress();
        int events = 0;
        while ((events & id << RELEASES) == 0) {
            events = waitForAnyEvent(0);
        }
    }

    public static int waitForAnyPress() {
        return waitForAnyPress(0);
    }

    /** The bits of the buttons pressed; 0 after so many milliseconds without, where 0 waits on. */
    public static int waitForAnyPress(int timeout) {
        long end = end(timeout);
        int events = 0;
        while (events == 0 && BRICK.milliseconds() < end) {
            events = awaitEvent(end) & (1 << RELEASES) - 1;
        }
        return events;
    }

    /** Like {@link #waitForAnyPress(int)}; releases are bits eight places higher. */
    public static int waitForAnyEvent(int timeout) {
        return awaitEvent(end(timeout));
    }

    private static long end(int timeout) {
        return timeout == 0 ? Long.MAX_VALUE : BRICK.milliseconds() + timeout;
    }

    private static int awaitEvent(long end) {
        int before = waited;
        int now = BRICK.keypad().down();
        while (now == before && BRICK.milliseconds() < end) {
            BRICK.time().waitUntil(BRICK.tickAfter(1));
            now = BRICK.keypad().down();
        }
        waited = now;
        return (before & ~now) << RELEASES | now & ~before;
    }

    /** As on the brick, there is room for four. */
    public void addButtonListener(ButtonListener aListener) {
        if (listeners == null) {
            listeners = new ButtonListener[ROOM];
            wasDown = isDown();
            ListenerThread.OF_INPUTS.watch(this, this::hasChanged, PERIOD);
        }
        listeners[count++] = aListener;
    }

    /** What is seen now; a change that was undone before is not told. */
    @Override
    public int callListeners() {
        wasDown = isDown();
        for (int i = 0; i < count; i++) {
            if (wasDown) {
                listeners[i].buttonPressed(this);
            } else {
                listeners[i].buttonReleased(this);
            }
        }
        return wasDown ? id << RELEASES : id;
    }

    private boolean hasChanged() {
        return isDown() != wasDown;
    }

    public static void setKeyClickVolume(int vol) {
        clickVolume = vol;
    }

    public static int getKeyClickVolume() {
        return clickVolume;
    }

    public static void setKeyClickLength(int len) {
        clickLength = len;
    }

    public static int getKeyClickLength() {
        return clickLength;
    }

    public static void setKeyClickTone(int key, int freq) {
        clickTones[key] = freq;
    }

    public static int getKeyClickTone(int key) {
        return clickTones[key];
    }

    public static void loadSettings() {
        loadSystemSettings();
    }

    public static void loadSystemSettings() {
        clickVolume = USUAL_VOLUME;
        clickLength = USUAL_LENGTH;
        clickTones = Arrays.copyOf(USUAL_TONES, USUAL_TONES.length);
    }
}

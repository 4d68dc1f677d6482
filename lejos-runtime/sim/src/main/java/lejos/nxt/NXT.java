package lejos.nxt;

import arcomat.sim.device.Hardware;

/** The brick as a whole. */
public class NXT {
    private static final Hardware BRICK = Hardware.of(NXT.class);
    private static final int MAJOR = 0;
    private static final int MINOR = 9;
    private static final int PATCH_LEVEL = 1;

    /** Switches the brick off: the program ends. */
    public static void shutDown() {
        BRICK.lifetime().exit();
        BRICK.time().spend(0); // does not return
    }

    public static int getFirmwareRawVersion() {
        return MAJOR << 16 | MINOR << 8 | PATCH_LEVEL;
    }

    public static int getFirmwareMajorVersion() {
        return MAJOR;
    }

    public static int getFirmwareMinorVersion() {
        return MINOR;
    }

    public static int getFirmwarePatchLevel() {
        return PATCH_LEVEL;
    }
}

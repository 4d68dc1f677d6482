package lejos.nxt.comm;

import arcomat.sim.device.Hardware;

/** A way to other bricks. */
public abstract class NXTCommDevice {
    private static final Hardware BRICK = Hardware.of(NXTCommDevice.class);

    /** The name by which other bricks call this one. */
    public static String getName() {
        return BRICK.name();
    }
}

package lejos.nxt;

import arcomat.sim.device.Hardware;

/** The battery. */
public class Battery {
    private static final Hardware BRICK = Hardware.of(Battery.class);
    private static final float MILLI = 1000;

    private Battery() {}

    public static int getVoltageMilliVolt() {
        return BRICK.called().batteryMillivolts();
    }

    public static float getVoltage() {
        return getVoltageMilliVolt() / MILLI;
    }

    public static boolean isRechargeable() {
        return false;
    }
}

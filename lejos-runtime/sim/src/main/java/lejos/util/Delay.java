package lejos.util;

import arcomat.sim.device.Hardware;
import arcomat.sim.time.VirtualTime;

/** Waiting; an interrupt does not cut it short. */
public class Delay {
    private static final Hardware BRICK = Hardware.of(Delay.class);
    private static final long NANOSECONDS_PER_MICROSECOND = 1000;

    public static void msDelay(long period) {
        BRICK.sleep(period);
    }

    public static void usDelay(long period) {
        VirtualTime time = BRICK.time();
        time.waitUntil(time.now() + Math.max(0, period));
    }

    public static void nsDelay(long period) {
        usDelay(period / NANOSECONDS_PER_MICROSECOND);
    }
}

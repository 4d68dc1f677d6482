package lean.sensors;

import lejos.nxt.SensorPort;
import lejos.nxt.UltrasonicSensor;

/** Looks ahead. Between near and far it says nothing, so that the robot does not jitter. */
public final class DistanceSensor {
    public static final int UNKNOWN = 0;
    public static final int CLEAR = 1;
    public static final int TOO_CLOSE = 2;

    /** In cm. */
    private static final int NEAR = 25;

    private static final int FAR = 35;

    private final UltrasonicSensor device;

    public DistanceSensor(SensorPort port) {
        device = new UltrasonicSensor(port);
    }

    public int range() {
        int distance = device.getDistance();
        if (distance <= NEAR) {
            return TOO_CLOSE;
        }
        return distance >= FAR ? CLEAR : UNKNOWN;
    }
}

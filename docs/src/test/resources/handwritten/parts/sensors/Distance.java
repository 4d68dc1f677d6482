package parts.sensors;

import lejos.nxt.SensorPort;
import lejos.nxt.UltrasonicSensor;

/** The ultrasonic sensor, which measures every 60 ms and would make who asks more often wait. */
public final class Distance {
    private static final int MEASURING = 60;

    private final UltrasonicSensor device;
    private int distance;
    private long next;

    public Distance(SensorPort port) {
        device = new UltrasonicSensor(port);
    }

    /** In cm; 255 for nothing in range. */
    public int read() {
        long now = System.currentTimeMillis();
        if (now >= next) {
            distance = device.getDistance();
            next = now + MEASURING;
        }
        return distance;
    }
}

package nxt.sensors;

import lejos.nxt.SensorPort;

/**
 * Platform component nxt.UltrasonicSensor on the brick. The device measures every 60 ms; asked more
 * often, it would make the program wait.
 */
public final class UltrasonicSensor {
    private static final int NOTHING = 255;

    /** From one measurement to the next, in milliseconds. */
    private static final int MEASURING = 60;

    /** In cm; 255 for nothing in range. */
    public int distance = NOTHING;

    private final lejos.nxt.UltrasonicSensor device;

    /** When the device is to be asked again, by the clock of the brick. */
    private long next;

    public UltrasonicSensor(int socket) {
        device = new lejos.nxt.UltrasonicSensor(SensorPort.getInstance(socket - 1));
    }

    /** Samples the device: the start of a slice. */
    public void sense() {
        long now = System.currentTimeMillis();
        if (now >= next) {
            distance = device.getDistance();
            next = now + MEASURING;
        }
    }
}

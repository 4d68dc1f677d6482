package nxt.sensors;

import lejos.nxt.SensorPort;

/** Platform component nxt.SoundSensor on the brick. */
public final class SoundSensor {
    /** In percent. */
    public int level;

    private final lejos.nxt.SoundSensor device;

    public SoundSensor(int socket) {
        // true: it weighs frequencies as the human ear does.
        device = new lejos.nxt.SoundSensor(SensorPort.getInstance(socket - 1), true);
    }

    /** Samples the device: the start of a slice. */
    public void sense() {
        level = Math.max(0, Math.min(100, device.readValue()));
    }
}

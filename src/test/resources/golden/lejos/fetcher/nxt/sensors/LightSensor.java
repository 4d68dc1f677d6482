package nxt.sensors;

import lejos.nxt.SensorPort;

/** Platform component nxt.LightSensor on the brick, with the lamp on. */
public final class LightSensor {
    /** In percent between dark and bright. */
    public int value;

    private final lejos.nxt.LightSensor device;

    public LightSensor(int socket, int dark, int bright) {
        device = new lejos.nxt.LightSensor(SensorPort.getInstance(socket - 1), true);
        device.setLow(dark);
        device.setHigh(bright);
    }

    /**
     * Samples the device: the start of a slice. The device does not keep to 0 to 100, this does.
     */
    public void sense() {
        value = Math.max(0, Math.min(100, device.getLightValue()));
    }
}

package parts.sensors;

import lejos.nxt.LightSensor;
import lejos.nxt.SensorPort;

/** The light sensor, which does not keep to its percentage by itself. */
public final class Brightness {
    private final LightSensor device;

    public Brightness(SensorPort port) {
        device = new LightSensor(port);
    }

    /** In percent. */
    public int read() {
        return Math.max(0, Math.min(100, device.getLightValue()));
    }
}

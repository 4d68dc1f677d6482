package nxt.sensors;

import lejos.nxt.SensorPort;

/** Platform component nxt.TouchSensor on the brick. */
public final class TouchSensor {
    public boolean pressed;

    private final lejos.nxt.TouchSensor device;

    public TouchSensor(int socket) {
        device = new lejos.nxt.TouchSensor(SensorPort.getInstance(socket - 1));
    }

    /** Samples the device: the start of a slice. */
    public void sense() {
        pressed = device.isPressed();
    }
}

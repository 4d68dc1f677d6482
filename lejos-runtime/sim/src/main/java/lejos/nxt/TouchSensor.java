package lejos.nxt;

import lejos.robotics.Touch;

/** The touch sensor. */
public class TouchSensor implements SensorConstants, Touch {
    private final ADSensorPort port;

    public TouchSensor(ADSensorPort port) {
        this.port = port;
        port.setTypeAndMode(TYPE_SWITCH, MODE_BOOLEAN);
    }

    @Override
    public boolean isPressed() {
        return port.readBooleanValue();
    }
}

package p.sensors;

import lejos.nxt.SensorPort;
import lejos.nxt.SensorPortListener;
import lejos.nxt.TouchSensor;

/** Hears of its socket whenever it changes. */
public class Bumper implements SensorPortListener {
    private final TouchSensor touch = new TouchSensor(SensorPort.S1);

    private boolean pressed;

    public Bumper() {
        SensorPort.S1.addSensorPortListener(this);
    }

    public void stateChanged(SensorPort port, int before, int now) {
        if (touch.isPressed() != pressed) {
            pressed = !pressed;
            sendPressed(pressed);
        }
    }

    protected void sendPressed(boolean message) {}
}

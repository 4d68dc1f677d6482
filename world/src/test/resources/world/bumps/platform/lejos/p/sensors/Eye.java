package p.sensors;

import lejos.nxt.SensorPort;
import lejos.nxt.UltrasonicSensor;
import lejos.util.Timer;
import lejos.util.TimerListener;

/** Looks now and then, and tells what is new. */
public class Eye implements TimerListener {
    private final UltrasonicSensor eye = new UltrasonicSensor(SensorPort.S2);

    private int last = 255;

    public Eye() {
        new Timer(150, this).start();
    }

    public void timedOut() {
        int seen = eye.getDistance();
        if (seen != last) {
            last = seen;
            sendDistance(seen);
        }
    }

    protected void sendDistance(int message) {}
}

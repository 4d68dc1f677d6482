package parts;

import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.nxt.TouchSensor;

import parts.logic.AvoidCrash;
import parts.logic.CupHolder;
import parts.logic.LineStatus;
import parts.logic.Proximity;
import parts.logic.Timer;
import parts.motors.Drive;
import parts.motors.Wheel;
import parts.sensors.Brightness;
import parts.sensors.Distance;

/**
 * The coffee fetcher written by hand, of parts that other robots use as well: the parts of the
 * model in models/coffee/coffee/fetcher, and for the same rows in every run.
 */
public final class Fetcher extends Robot {
    private final Distance ahead = new Distance(SensorPort.S1);
    private final Brightness left = new Brightness(SensorPort.S2);
    private final Brightness right = new Brightness(SensorPort.S3);
    private final TouchSensor cup = new TouchSensor(SensorPort.S4);
    private final Proximity proximity = new Proximity(25, 35);
    private final LineStatus line = new LineStatus(45);
    private final CupHolder cupHolder = new CupHolder();
    private final AvoidCrash avoidCrash = new AvoidCrash();
    private final Timer timer = new Timer(2);
    private final Drive drive = new Drive(new Wheel(Motor.A), new Wheel(Motor.B));

    private Fetcher() {}

    public static void main(String[] args) {
        new Fetcher().run(100);
    }

    /** What was decided a slice ago is carried out, while the next decision is made. */
    protected void slice() {
        int front = proximity.judge(ahead.read());
        line.look(left.read(), right.read());
        boolean alert = timer.isAlert();
        timer.step(avoidCrash.startsTimer());
        drive.step(avoidCrash.command(), line.drift());
        avoidCrash.step(front, alert, line.isLost(), cupHolder.isFull());
        cupHolder.step(cup.isPressed());
    }
}

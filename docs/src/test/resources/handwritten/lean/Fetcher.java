package lean;

import lean.logic.AvoidCrash;
import lean.logic.CupHolder;
import lean.motors.Drive;
import lean.sensors.DistanceSensor;
import lean.sensors.LineSensor;

import lejos.nxt.Button;
import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.nxt.TouchSensor;
import lejos.util.Delay;

/**
 * The coffee fetcher, written by hand: what the models in models/coffee/coffee/fetcher say, for the
 * same rows in every run. Sensors, logic, motors; ten times a second until ESCAPE is pressed.
 */
public final class Fetcher {
    private static final int CYCLE = 100;

    /** The longest that motors take to stand, in milliseconds, and how often they are looked at. */
    private static final int BRAKING = 500;

    private static final int LOOK = 50;

    private final DistanceSensor distance = new DistanceSensor(SensorPort.S1);
    private final LineSensor line = new LineSensor(SensorPort.S2, SensorPort.S3);
    private final TouchSensor cup = new TouchSensor(SensorPort.S4);
    private final CupHolder cupHolder = new CupHolder();
    private final AvoidCrash avoidCrash = new AvoidCrash();
    private final Drive drive = new Drive(Motor.A, Motor.B);

    private Fetcher() {}

    public static void main(String[] args) {
        try {
            new Fetcher().run();
        } finally {
            stop();
        }
    }

    private void run() {
        long next = System.currentTimeMillis();
        while (!Button.ESCAPE.isDown()) {
            slice();
            next += CYCLE;
            Delay.msDelay(next - System.currentTimeMillis());
        }
    }

    /** What was decided a cycle ago is carried out, while the next decision is made. */
    private void slice() {
        int range = distance.range();
        line.look();
        boolean pressed = cup.isPressed();

        drive.obey(avoidCrash.command(), line.drift());
        avoidCrash.decide(range, line.isLost(), cupHolder.isFull());
        cupHolder.feel(pressed);
    }

    /** The end of a program lets motors go, so they get time to brake. */
    private static void stop() {
        Motor.A.stop(true);
        Motor.B.stop(true);
        Motor.C.stop(true);
        for (int waited = 0; waited < BRAKING && isMoving(); waited += LOOK) {
            Delay.msDelay(LOOK);
        }
    }

    private static boolean isMoving() {
        return Motor.A.isMoving() || Motor.B.isMoving() || Motor.C.isMoving();
    }
}

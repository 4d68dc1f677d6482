package p.actuators;

import lejos.nxt.Motor;
import lejos.nxt.NXTRegulatedMotor;

/** Two wheels that turn at one speed. */
public class Wheels {
    public void speed(int message) {
        turn(Motor.A, message);
        turn(Motor.B, message);
    }

    private static void turn(NXTRegulatedMotor wheel, int speed) {
        wheel.setSpeed(Math.abs(speed));
        if (speed > 0) {
            wheel.forward();
        } else if (speed < 0) {
            wheel.backward();
        } else {
            wheel.stop(true);
        }
    }
}

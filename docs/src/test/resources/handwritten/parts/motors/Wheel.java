package parts.motors;

import lejos.nxt.NXTRegulatedMotor;

/** A motor with a signed speed. It is told again only what has changed, or if it was held up. */
public final class Wheel {
    private static final int LIMIT = 10000;

    private final NXTRegulatedMotor motor;
    private int speed;

    public Wheel(NXTRegulatedMotor motor) {
        this.motor = motor;
    }

    /** In degrees per second; negative backwards, 0 stops. */
    public void turn(int wanted) {
        if (wanted != speed) {
            speed = wanted;
            if (wanted != 0) {
                motor.setSpeed(Math.min(LIMIT, Math.abs(wanted)));
            }
            go();
        } else if (wanted != 0 && !motor.isMoving()) {
            go();
        }
    }

    private void go() {
        if (speed == 0) {
            motor.stop(true);
        } else if (speed > 0) {
            motor.forward();
        } else {
            motor.backward();
        }
    }
}

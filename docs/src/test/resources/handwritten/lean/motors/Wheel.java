package lean.motors;

import lejos.nxt.NXTRegulatedMotor;

/** A motor with a signed speed. It is told again only what has changed, or if it was held up. */
final class Wheel {
    private final NXTRegulatedMotor motor;
    private int speed;

    Wheel(NXTRegulatedMotor motor) {
        this.motor = motor;
    }

    /** In degrees per second; negative backwards, 0 stops. */
    void turn(int wanted) {
        if (wanted == speed && (wanted == 0 || motor.isMoving())) {
            return;
        }
        speed = wanted;
        if (wanted == 0) {
            motor.stop(true);
            return;
        }
        motor.setSpeed(Math.abs(wanted));
        if (wanted > 0) {
            motor.forward();
        } else {
            motor.backward();
        }
    }
}

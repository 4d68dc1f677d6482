package arcomat.nxt;

import lejos.nxt.Motor;
import lejos.nxt.NXTRegulatedMotor;

/** What a motor turns. It keeps its speed until the next one; no call waits for the motor. */
public final class Shaft {
    /** In degrees per second, more than any motor reaches. */
    private static final int LIMIT = 10000;

    private final NXTRegulatedMotor motor;
    private int speed;

    /**
     * @param socket code of nxt.Brick.MotorPort
     */
    public Shaft(int socket) {
        motor = Motor.getInstance(socket - 1);
    }

    /**
     * Changes the speed. One that has been asked for before is looked after only if something held
     * the motor and it has given up.
     *
     * @param wanted in degrees per second; negative turns backwards, 0 stops and holds
     */
    public void turn(int wanted) {
        if (wanted != speed) {
            change(wanted);
        } else if (wanted != 0 && !motor.isMoving()) {
            go(wanted);
        }
    }

    /** A turning motor takes a new speed as it goes; it is sent on its way only for another one. */
    private void change(int wanted) {
        if (wanted == 0) {
            // true: return at once, and not when the motor stands.
            motor.stop(true);
        } else {
            motor.setSpeed(Math.abs(Math.max(-LIMIT, Math.min(LIMIT, wanted))));
            boolean sameWay = wanted > 0 ? speed > 0 : speed < 0;
            if (!sameWay || !motor.isMoving()) {
                go(wanted);
            }
        }
        speed = wanted;
    }

    private void go(int wanted) {
        if (wanted > 0) {
            motor.forward();
        } else {
            motor.backward();
        }
    }
}

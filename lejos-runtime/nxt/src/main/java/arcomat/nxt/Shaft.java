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
     * Changes the speed.
     *
     * @param wanted in degrees per second; negative turns backwards, 0 stops and holds
     */
    public void turn(int wanted) {
        int limited = Math.max(-LIMIT, Math.min(LIMIT, wanted));
        if (limited == 0) {
            stop();
        } else {
            drive(limited);
        }
        speed = limited;
    }

    private void stop() {
        if (speed != 0) {
            // true: return at once, and not when the motor stands.
            motor.stop(true);
        }
    }

    /**
     * A turning motor takes a new speed as it goes. It is sent on its way only where it is to
     * change its direction, stands, or has given up because something held it.
     */
    private void drive(int wanted) {
        if (wanted != speed) {
            motor.setSpeed(Math.abs(wanted));
        }
        boolean sameWay = wanted > 0 ? speed > 0 : speed < 0;
        if (!sameWay || !motor.isMoving()) {
            if (wanted > 0) {
                motor.forward();
            } else {
                motor.backward();
            }
        }
    }
}

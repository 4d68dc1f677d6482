package arcomat.live.robot;

import arcomat.sim.device.MotorDevice;
import arcomat.sim.device.MotorOrder;

/**
 * What a motor turns: keeps its speed until the next one. Which calls that takes depends on how the
 * motor turns already.
 */
final class Shaft {
    /** In degrees per second, more than any motor reaches. */
    private static final int LIMIT = 10_000;

    /** In degrees per second, each second. */
    private static final int ACCELERATION = 6000;

    private final Routine routine;
    private final MotorDevice motor;
    private int wanted;

    /** What the regulator aims at, and which way it was sent last. */
    private int pace;

    private int way;

    Shaft(Routine routine, MotorDevice motor) {
        this.routine = routine;
        this.motor = motor;
    }

    /**
     * @param speed in degrees per second; negative turns backwards, 0 stops and holds
     */
    void turn(int speed) {
        if (speed != wanted) {
            change(speed);
            wanted = speed;
        } else if (speed != 0) {
            goIfItStands(speed);
        }
    }

    private void change(int speed) {
        if (speed == 0) {
            stop();
            return;
        }
        pace(Math.abs(Math.max(-LIMIT, Math.min(LIMIT, speed))));
        if (Integer.signum(speed) == Integer.signum(wanted)) {
            goIfItStands(speed);
        } else {
            go(speed);
        }
    }

    /** Stops and holds; nobody waits for that. */
    void stop() {
        routine.call(() -> motor.stop(ACCELERATION));
    }

    /** A motor that turns takes a new speed as it goes. */
    private void pace(int newPace) {
        pace = newPace;
        routine.call(
                () -> {
                    if (motor.order() == MotorOrder.TURN && motor.isMoving()) {
                        motor.turn(way < 0 ? -pace : pace, ACCELERATION);
                    }
                });
    }

    private void goIfItStands(int speed) {
        routine.call(
                () -> {
                    if (!motor.isMoving()) {
                        go(speed);
                    }
                });
    }

    private void go(int speed) {
        routine.call(
                () -> {
                    way = Integer.signum(speed);
                    motor.turn(way * pace, ACCELERATION);
                });
    }
}

package arcomat.live.robot;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.MotorName;
import arcomat.sim.device.Screen;

/**
 * What a program does whose model goes wrong: all motors stop at once, and when they stand the
 * display says why, for good.
 */
record Failure(Hardware brick, Routine routine, String reason) {
    /** The longest that motors take to stand, and from one look at them to the next, in ms. */
    private static final int BRAKING = 500;

    private static final int LOOK = 50;

    void show() {
        for (MotorName motor : MotorName.values()) {
            new Shaft(routine, brick.motor(motor.ordinal())).stop();
        }
        routine.call(() -> look(brick.milliseconds(), 0));
    }

    /**
     * @param next when to look again
     * @param waited milliseconds so far
     */
    private void look(long next, int waited) {
        if (waited > BRAKING) {
            tell();
        } else {
            ask(0, next, waited);
        }
    }

    /** One motor after the other, up to the first that moves. */
    private void ask(int motor, long next, int waited) {
        if (motor == MotorName.values().length) {
            tell();
            return;
        }
        routine.call(
                () -> {
                    if (brick.motor(motor).isMoving()) {
                        routine.call(() -> await(next, waited));
                    } else {
                        ask(motor + 1, next, waited);
                    }
                });
    }

    private void await(long next, int waited) {
        long wait = next - brick.milliseconds();
        if (wait > 0) {
            routine.until(() -> brick.tickAfter(wait), () -> {});
        }
        routine.loop();
        routine.then(() -> look(next + LOOK, waited + LOOK));
    }

    private void tell() {
        routine.call(() -> brick.screen().clear());
        for (int row = 0; row < Screen.ROWS && row * Screen.COLUMNS < reason.length(); row++) {
            int top = row;
            int end = Math.min(reason.length(), (row + 1) * Screen.COLUMNS);
            String text = reason.substring(row * Screen.COLUMNS, end);
            routine.loop();
            routine.call(() -> brick.screen().draw(text, 0, top));
        }
    }
}

package arcomat.nxt;

import arcomat.rt.Cycle;

import lejos.nxt.Button;
import lejos.nxt.LCD;
import lejos.nxt.Motor;

/**
 * A program on the brick: one slice per cycle, until ESCAPE is pressed. However it ends, the motors
 * stand still afterwards. What went wrong stays on the display until ESCAPE is pressed.
 */
public abstract class Robot {
    private static final int COLUMNS = 16;
    private static final int ROWS = 8;

    /** The longest that motors take to stand, in milliseconds. */
    private static final int BRAKING = 500;

    /** From one look at motors that brake, or at ESCAPE, to the next, in milliseconds. */
    private static final int LOOK = 50;

    /** Creates the components. */
    protected abstract void start();

    /** Samples the sensors, lets the logic react, and carries out what it says. */
    protected abstract void slice();

    /**
     * Runs the program.
     *
     * @param cycle length of a slice in milliseconds
     */
    public final void run(int cycle) {
        Throwable problem = null;
        try {
            start();
            runSlices(new Cycle(cycle));
        } catch (Throwable e) {
            problem = e;
        } finally {
            stopMotors();
        }
        if (problem != null) {
            show(problem);
        }
    }

    private void runSlices(Cycle cycle) {
        while (cycle.await() && !Button.ESCAPE.isDown()) {
            slice();
        }
    }

    /**
     * All at once, for another motor would run on while one is waited for. Then until they stand:
     * the end of a program lets them go, braked or not. A motor that something else keeps turning
     * is not waited for.
     */
    private static void stopMotors() {
        Motor.A.stop(true);
        Motor.B.stop(true);
        Motor.C.stop(true);
        Cycle look = new Cycle(LOOK);
        for (int waited = 0; waited <= BRAKING && isMoving() && look.await(); waited += LOOK) {
            // They brake.
        }
    }

    private static boolean isMoving() {
        return Motor.A.isMoving() || Motor.B.isMoving() || Motor.C.isMoving();
    }

    private static void show(Throwable problem) {
        String text = problem.getMessage() == null ? problem.toString() : problem.getMessage();
        LCD.clear();
        for (int row = 0; row < ROWS && row * COLUMNS < text.length(); row++) {
            int end = Math.min(text.length(), (row + 1) * COLUMNS);
            LCD.drawString(text.substring(row * COLUMNS, end), 0, row);
        }
        Cycle cycle = new Cycle(LOOK);
        while (cycle.await() && !Button.ESCAPE.isDown()) {
            // The text stays.
        }
    }
}

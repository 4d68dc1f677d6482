package parts;

import lejos.nxt.Button;
import lejos.nxt.LCD;
import lejos.nxt.Motor;
import lejos.util.Delay;

/** What all our robots have in common: a loop until ESCAPE is pressed, and a safe end. */
public abstract class Robot {
    private static final int COLUMNS = 16;
    private static final int ROWS = 8;

    /** The longest that motors take to stand, in milliseconds, and how often they are looked at. */
    private static final int BRAKING = 500;

    private static final int LOOK = 50;

    protected abstract void slice();

    /**
     * @param cycle length of a slice in milliseconds
     */
    protected final void run(int cycle) {
        try {
            long next = System.currentTimeMillis();
            while (!Button.ESCAPE.isDown()) {
                slice();
                next += cycle;
                Delay.msDelay(next - System.currentTimeMillis());
            }
        } catch (RuntimeException problem) {
            stop();
            show(problem.toString());
        } finally {
            stop();
        }
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

    private static void show(String text) {
        LCD.clear();
        for (int row = 0; row < ROWS && row * COLUMNS < text.length(); row++) {
            int end = Math.min(text.length(), (row + 1) * COLUMNS);
            LCD.drawString(text.substring(row * COLUMNS, end), 0, row);
        }
        while (!Button.ESCAPE.isDown()) {
            Delay.msDelay(LOOK);
        }
    }
}

package arcomat.live.robot;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.Screen;

/**
 * A row of the display, drawn letter by letter.
 *
 * @param row from the top, 0 to 7
 */
record Lettering(Routine routine, Hardware brick, int row) {
    private static final int LAST = Screen.COLUMNS - 1;

    /** Shows a text from the left; the rest of the row is blank. */
    void show(String text) {
        routine.loop();
        for (int column = 0; column <= LAST; column++) {
            draw(text, column);
            routine.loop();
        }
    }

    /** Shows a number at the right, before it a text. */
    void show(String label, int number) {
        String digits = String.valueOf(number);
        int first = LAST + 1 - digits.length();
        for (int column = LAST; column >= first; column--) {
            char letter = digits.charAt(column - first);
            draw(letter, column);
            if (letter != '-') {
                routine.loop();
            }
        }
        routine.loop();
        for (int column = first - 1; column >= 0; column--) {
            draw(label, column);
            routine.loop();
        }
    }

    private void draw(String text, int column) {
        char letter = column < text.length() ? text.charAt(column) : ' ';
        // The display has ASCII only.
        draw(letter < ' ' || letter > '~' ? '?' : letter, column);
    }

    private void draw(char letter, int column) {
        routine.call(() -> brick.screen().draw(letter, column, row));
    }
}

package arcomat.nxt;

import lejos.nxt.LCD;

/** A row of the display. Characters are drawn one by one, so that nothing is allocated. */
public final class Row {
    private static final int LAST = LCD.DISPLAY_CHAR_WIDTH - 1;

    private final int row;

    /**
     * @param row from the top, 0 to 7
     */
    public Row(int row) {
        this.row = row;
    }

    /** Shows a text from the left; the rest of the row is blank. */
    public void show(String text) {
        for (int column = 0; column <= LAST; column++) {
            draw(text, column);
        }
    }

    /** Shows a number at the right, before it a text. */
    public void show(String label, int number) {
        int column = LAST;
        // Negative, because the least number has no positive counterpart.
        int rest = number < 0 ? number : -number;
        do {
            LCD.drawChar((char) ('0' - rest % 10), column--, row);
            rest /= 10;
        } while (rest != 0);
        if (number < 0) {
            LCD.drawChar('-', column--, row);
        }
        for (; column >= 0; column--) {
            draw(label, column);
        }
    }

    private void draw(String text, int column) {
        char letter = column < text.length() ? text.charAt(column) : ' ';
        // The display has ASCII only, and draws nothing over the old letter for any other.
        LCD.drawChar(letter < ' ' || letter > '~' ? '?' : letter, column, row);
    }
}

package nxt.actuators;

import arcomat.nxt.Row;

/** Platform component nxt.LcdLogger on the brick. */
public final class LcdLogger {
    public String text;

    public boolean hasText;

    private final Row row;

    public LcdLogger(int row) {
        this.row = new Row(row);
    }

    /** Carries out the message of a slice. */
    public void act() {
        if (hasText) {
            row.show(text);
        }
    }
}

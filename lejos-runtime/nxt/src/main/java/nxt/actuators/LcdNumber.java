package nxt.actuators;

import arcomat.nxt.Row;

/** Platform component nxt.LcdNumber on the brick. */
public final class LcdNumber {
    public int number;

    public boolean hasNumber;

    private final Row row;
    private final String label;
    private int shown;
    private boolean isShown;

    public LcdNumber(int row, String label) {
        this.row = new Row(row);
        this.label = label;
        this.row.show(label);
    }

    /**
     * Carries out the message of a slice. Drawing takes some milliseconds, so only what is new is
     * drawn.
     */
    public void act() {
        if (hasNumber && (number != shown || !isShown)) {
            row.show(label, number);
            shown = number;
            isShown = true;
        }
    }
}

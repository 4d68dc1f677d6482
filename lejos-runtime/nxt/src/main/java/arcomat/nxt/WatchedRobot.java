package arcomat.nxt;

import arcomat.rt.Monitor;

/**
 * A program on the brick that watches itself. What is violated is shown, with its slice. Where the
 * program goes on, that takes the last rows of the display, whatever else is written there.
 */
public abstract class WatchedRobot extends Robot {
    private static final int COLUMNS = 16;

    private static final int FIRST_ROW = 5;
    private static final int ROWS = 3;

    /** More would neither fit into the memory nor be followed in time. */
    private static final int MOST_RUNS = 32;

    /** The first one that is violated, or else the first one that cannot go on. */
    private Monitor shown;

    private final Row[] rows = new Row[ROWS];
    private final String[] texts = new String[ROWS];

    /** Prepares a monitor. */
    protected static void begin(Monitor monitor) {
        monitor.followAtMost(MOST_RUNS);
    }

    /** Judges a slice; a violation ends the program, and is what it has to say. */
    protected final void demand(Monitor monitor) {
        if (!monitor.slice()) {
            throw new Violation(monitor.violation());
        }
        showUnknown(monitor);
    }

    /** Judges a slice; a violation is shown, and the program goes on. */
    protected final void goOn(Monitor monitor) {
        if (!monitor.slice()) {
            if (shown == null || shown.violation().length() == 0) {
                choose(monitor, monitor.violation());
            }
            show(monitor);
        }
        showUnknown(monitor);
    }

    private void showUnknown(Monitor monitor) {
        if (monitor.unknown().length() > 0) {
            if (shown == null) {
                choose(monitor, monitor.requirement() + ": " + monitor.unknown());
            }
            show(monitor);
        }
    }

    private void choose(Monitor monitor, String text) {
        shown = monitor;
        for (int row = 0; row < ROWS; row++) {
            int start = Math.min(text.length(), row * COLUMNS);
            int end = Math.min(text.length(), start + COLUMNS);
            texts[row] = text.substring(start, end);
            rows[row] = new Row(FIRST_ROW + row);
        }
    }

    private void show(Monitor monitor) {
        if (shown == monitor) {
            showRows();
        }
    }

    private void showRows() {
        for (int row = 0; row < ROWS; row++) {
            rows[row].show(texts[row]);
        }
    }
}

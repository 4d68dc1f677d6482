package arcomat.sim.device;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The screen as text: 8 rows of 16 characters. What does not fit is cut off. */
public final class Screen {
    public static final int COLUMNS = 16;
    public static final int ROWS = 8;

    private final Hardware hardware;
    private final char[] cells = new char[COLUMNS * ROWS];

    Screen(Hardware hardware) {
        this.hardware = hardware;
        Arrays.fill(cells, ' ');
    }

    public void draw(String text, int column, int row) {
        boolean changed = false;
        for (int i = 0; i < text.length(); i++) {
            changed |= set(column + i, row, text.charAt(i));
        }
        report(changed);
    }

    public void draw(char character, int column, int row) {
        report(set(column, row, character));
    }

    public void clear(int column, int row, int length) {
        boolean changed = false;
        for (int i = 0; i < length; i++) {
            changed |= set(column + i, row, ' ');
        }
        report(changed);
    }

    public void clear() {
        boolean changed = false;
        for (int row = 0; row < ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                changed |= set(column, row, ' ');
            }
        }
        report(changed);
    }

    /** Moves every row up; the lowest becomes empty. */
    public void scroll() {
        System.arraycopy(cells, COLUMNS, cells, 0, cells.length - COLUMNS);
        Arrays.fill(cells, cells.length - COLUMNS, cells.length, ' ');
        report(true);
    }

    /** The rows from top to bottom, without spaces at their ends. */
    public List<String> rows() {
        List<String> rows = new ArrayList<>();
        for (int row = 0; row < ROWS; row++) {
            rows.add(new String(cells, row * COLUMNS, COLUMNS).stripTrailing());
        }
        return List.copyOf(rows);
    }

    private boolean set(int column, int row, char character) {
        if (column < 0 || column >= COLUMNS || row < 0 || row >= ROWS || !isDrawn(character)) {
            return false;
        }
        int cell = row * COLUMNS + column;
        boolean changed = cells[cell] != character;
        cells[cell] = character;
        return changed;
    }

    /** The display knows the letters of ASCII; where another one is drawn, the old one stays. */
    private static boolean isDrawn(char character) {
        return character >= ' ' && character <= '~';
    }

    private void report(boolean changed) {
        if (changed) {
            hardware.observer().screenChanged(hardware.time().now(), this);
        }
    }
}

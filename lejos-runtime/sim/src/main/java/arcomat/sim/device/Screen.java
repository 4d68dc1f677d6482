package arcomat.sim.device;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The screen as text: 8 rows of 16 characters. What does not fit is cut off. Points are kept beside
 * the text: letters have none, and nobody is told of them.
 */
public final class Screen {
    public static final int COLUMNS = 16;
    public static final int ROWS = 8;

    /** Points of the whole screen; one byte is a column of eight, the highest bit lowest. */
    public static final int WIDTH = 100;

    public static final int HEIGHT = 64;

    private static final int CELL_WIDTH = 6;

    private final Hardware hardware;
    private final byte[] points = new byte[WIDTH * HEIGHT / Byte.SIZE];
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
        Arrays.fill(points, (byte) 0);
        report(changed);
    }

    /** Moves every row up; the lowest becomes empty. */
    public void scroll() {
        System.arraycopy(points, WIDTH, points, 0, points.length - WIDTH);
        Arrays.fill(points, points.length - WIDTH, points.length, (byte) 0);
        System.arraycopy(cells, COLUMNS, cells, 0, cells.length - COLUMNS);
        Arrays.fill(cells, cells.length - COLUMNS, cells.length, ' ');
        report(true);
    }

    /** The rows from top to bottom, without spaces at their ends. */
    public List<String> rows() {
        List<String> rows = new ArrayList<>();
        for (int row = 0; row < ROWS; row++) {
            rows.add(row(row));
        }
        return List.copyOf(rows);
    }

    /** One row, without spaces at its end. */
    public String row(int number) {
        return new String(cells, number * COLUMNS, COLUMNS).stripTrailing();
    }

    /** The points; who writes here draws. */
    public byte[] points() {
        return points;
    }

    private boolean set(int column, int row, char character) {
        if (column < 0 || column >= COLUMNS || row < 0 || row >= ROWS || !isDrawn(character)) {
            return false;
        }
        int from = row * WIDTH + column * CELL_WIDTH;
        Arrays.fill(points, from, from + CELL_WIDTH, (byte) 0);
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

package lejos.nxt;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.Screen;

/** The screen, for text only. */
public class LCD {
    public static final int SCREEN_WIDTH = 100;
    public static final int SCREEN_HEIGHT = 64;
    public static final int CELL_WIDTH = 6;
    public static final int CELL_HEIGHT = 8;
    public static final int DISPLAY_CHAR_WIDTH = 16;
    public static final int DISPLAY_CHAR_DEPTH = 8;

    private static final Hardware BRICK = Hardware.of(LCD.class);

    public static void drawString(String str, int x, int y) {
        screen().draw(str, x, y);
    }

    /** Inverted text is shown as plain text. */
    public static void drawString(String str, int x, int y, boolean invert) {
        drawString(str, x, y);
    }

    public static void drawChar(char c, int x, int y) {
        screen().draw(c, x, y);
    }

    public static void drawInt(int i, int x, int y) {
        drawInt(i, 0, x, y);
    }

    /**
     * Right-aligned in so many places, where it is shorter. Digit by digit: nothing is allocated.
     */
    public static void drawInt(int i, int places, int x, int y) {
        Screen screen = screen();
        int length = length(i);
        int width = Math.max(places, length);
        screen.clear(x, y, width - length);
        long rest = Math.abs((long) i);
        for (int place = width - 1; place >= width - length; place--) {
            boolean sign = i < 0 && place == width - length;
            screen.draw(sign ? '-' : (char) ('0' + rest % 10), x + place, y);
            rest /= 10;
        }
    }

    private static int length(int number) {
        int length = number < 0 ? 2 : 1;
        for (int rest = number / 10; rest != 0; rest /= 10) {
            length++;
        }
        return length;
    }

    public static void clear() {
        screen().clear();
    }

    public static void clearDisplay() {
        clear();
    }

    public static void clear(int y) {
        screen().clear(0, y, DISPLAY_CHAR_WIDTH);
    }

    public static void clear(int x, int y, int n) {
        screen().clear(x, y, n);
    }

    public static void scroll() {
        screen().scroll();
    }

    /** Everything drawn is seen at once. */
    public static void refresh() {
        BRICK.called();
    }

    public static void asyncRefresh() {
        BRICK.called();
    }

    public static void asyncRefreshWait() {
        BRICK.called();
    }

    public static void setAutoRefresh(boolean on) {
        BRICK.called();
    }

    private static Screen screen() {
        return BRICK.called().screen();
    }
}

package lejos.nxt;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.Screen;

/**
 * The screen: text, which runs show, and points, which they do not. Letters are not made of points
 * here: text clears those below it, and asked for its points it has none.
 */
public class LCD {
    public static final int SCREEN_WIDTH = 100;
    public static final int SCREEN_HEIGHT = 64;
    public static final int CELL_WIDTH = 6;
    public static final int CELL_HEIGHT = 8;
    public static final int DISPLAY_CHAR_WIDTH = 16;
    public static final int DISPLAY_CHAR_DEPTH = 8;
    public static final int FONT_WIDTH = 5;
    public static final int FONT_HEIGHT = 8;
    public static final int NOOF_CHARS = 128;
    public static final int DEFAULT_REFRESH_PERIOD = 250;
    public static final int ROP_CLEAR = 0x00000000;
    public static final int ROP_AND = 0xff000000;
    public static final int ROP_ANDREVERSE = 0xff00ff00;
    public static final int ROP_COPY = 0x0000ff00;
    public static final int ROP_ANDINVERTED = 0xffff0000;
    public static final int ROP_NOOP = 0x00ff0000;
    public static final int ROP_XOR = 0x00ffff00;
    public static final int ROP_OR = 0xffffff00;
    public static final int ROP_NOR = 0xffffffff;
    public static final int ROP_EQUIV = 0x00ffffff;
    public static final int ROP_INVERT = 0x00ff00ff;
    public static final int ROP_ORREVERSE = 0xffff00ff;
    public static final int ROP_COPYINVERTED = 0x0000ffff;
    public static final int ROP_ORINVERTED = 0xff00ffff;
    public static final int ROP_NAND = 0xff0000ff;
    public static final int ROP_SET = 0x000000ff;

    private static final Hardware BRICK = Hardware.of(LCD.class);

    private static int refreshPeriod = DEFAULT_REFRESH_PERIOD;

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
        setAutoRefreshPeriod(on ? DEFAULT_REFRESH_PERIOD : 0);
    }

    /** Gives the period so far. */
    public static int setAutoRefreshPeriod(int period) {
        BRICK.called();
        int before = refreshPeriod;
        refreshPeriod = period;
        return before;
    }

    /** The screen is up to date now. */
    public static int getRefreshCompleteTime() {
        return (int) BRICK.called().milliseconds();
    }

    /** Is not seen in a trace. */
    public static void setContrast(int contrast) {
        BRICK.called();
    }

    /** The points of the screen themselves: who writes into them draws. */
    public static byte[] getDisplay() {
        return screen().points();
    }

    public static int getPixel(int x, int y) {
        return new Raster(getDisplay(), SCREEN_WIDTH, SCREEN_HEIGHT).get(x, y);
    }

    public static void setPixel(int x, int y, int color) {
        new Raster(getDisplay(), SCREEN_WIDTH, SCREEN_HEIGHT).set(x, y, color == 1 ? 1 : 0);
    }

    /** Combines points of a picture with those of the screen. */
    public static void bitBlt(
            byte[] src, int sw, int sh, int sx, int sy, int dx, int dy, int w, int h, int rop) {
        bitBlt(src, sw, sh, sx, sy, getDisplay(), SCREEN_WIDTH, SCREEN_HEIGHT, dx, dy, w, h, rop);
    }

    /** Combines points of a picture with those of another one. */
    public static void bitBlt(
            byte[] src,
            int sw,
            int sh,
            int sx,
            int sy,
            byte[] dst,
            int dw,
            int dh,
            int dx,
            int dy,
            int w,
            int h,
            int rop) {
        BRICK.called();
        Raster source = src == null ? null : new Raster(src, sw, sh);
        Raster target = new Raster(dst, dw, dh);
        for (int y = 0; y < h; y++) {
            for (int x = 0; x < w; x++) {
                int bit = source == null ? 0 : source.get(sx + x, sy + y);
                target.combine(dx + x, dy + y, bit, rop);
            }
        }
    }

    private static Screen screen() {
        return BRICK.called().screen();
    }
}

package lejos.nxt;

/**
 * A picture of points, as the display stores it: a byte is a column of eight points, rows of such
 * columns follow each other.
 */
final class Raster {
    private static final int COLUMN = 8;

    private final byte[] bytes;
    private final int width;
    private final int height;

    Raster(byte[] bytes, int width, int height) {
        this.bytes = bytes;
        this.width = width;
        this.height = height;
    }

    /** Outside there is nothing. */
    int get(int x, int y) {
        return isInside(x, y) ? bytes[place(x, y)] >> y % COLUMN & 1 : 0;
    }

    void set(int x, int y, int bit) {
        if (isInside(x, y)) {
            int mask = 1 << y % COLUMN;
            int others = bytes[place(x, y)] & ~mask;
            bytes[place(x, y)] = (byte) (bit == 0 ? others : others | mask);
        }
    }

    /**
     * Combines a point with another one.
     *
     * @param operation four masks, one byte each: what is there is and-ed with the bit masked by
     *     the first and flipped by the second, and flipped by the bit masked by the third and
     *     flipped by the fourth
     */
    void combine(int x, int y, int bit, int operation) {
        int and = bit & operation >> 24 ^ operation >> 16;
        int flip = bit & operation >> 8 ^ operation;
        set(x, y, (get(x, y) & and ^ flip) & 1);
    }

    private boolean isInside(int x, int y) {
        return x >= 0 && x < width && y >= 0 && y < height;
    }

    private int place(int x, int y) {
        return y / COLUMN * width + x;
    }
}

package lejos.robotics;

/** A colour: parts of red, green and blue from 0 to 255, and the number of the nearest name. */
public class Color {
    public static final int NONE = -1;
    public static final int RED = 0;
    public static final int GREEN = 1;
    public static final int BLUE = 2;
    public static final int YELLOW = 3;
    public static final int MAGENTA = 4;
    public static final int ORANGE = 5;
    public static final int WHITE = 6;
    public static final int BLACK = 7;
    public static final int PINK = 8;
    public static final int GRAY = 9;
    public static final int LIGHT_GRAY = 10;
    public static final int DARK_GRAY = 11;
    public static final int CYAN = 12;

    private final int red;
    private final int green;
    private final int blue;
    private final int color;

    public Color(int red, int green, int blue) {
        this(red, green, blue, NONE);
    }

    public Color(int red, int green, int blue, int color) {
        this.red = red;
        this.green = green;
        this.blue = blue;
        this.color = color;
    }

    public int getRed() {
        return red;
    }

    public int getGreen() {
        return green;
    }

    public int getBlue() {
        return blue;
    }

    public int getColor() {
        return color;
    }
}

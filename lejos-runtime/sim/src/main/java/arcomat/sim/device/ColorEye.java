package arcomat.sim.device;

/**
 * What a colour sensor sees: a surface of a colour, or one of which only the brightness is known.
 */
public final class ColorEye {
    /** The lamp; red, green and blue are also the parts of a colour. */
    public static final int RED = 0;

    public static final int GREEN = 1;
    public static final int BLUE = 2;
    public static final int DARK = 3;

    /** All three lamps in turn. */
    public static final int ALL = 4;

    /** The brightest part of a colour, and what the converter makes of it. */
    public static final int FULL_PART = 255;

    public static final int FULL_LEVEL = 1023;
    private static final int ABSENT = -1;
    private static final int PARTS = 3;

    /** As lejos.robotics.Color counts them, from red to cyan. */
    private static final int[] COLORS = {
        0xff0000, 0x00ff00, 0x0000ff, 0xffff00, 0xff00ff, 0xffc800, 0xffffff, 0x000000, 0xffafaf,
        0x808080, 0xc0c0c0, 0x404040, 0x00ffff
    };

    private final SensorSocket socket;

    ColorEye(SensorSocket socket) {
        this.socket = socket;
    }

    /** The colour as lejos.robotics.Color counts; -1 for none. */
    public int color() {
        return socket.color();
    }

    /** Red, green or blue of a colour, up to 255. */
    public static int part(int color, int lamp) {
        if (color < 0 || color >= COLORS.length || lamp >= PARTS) {
            return 0;
        }
        return COLORS[color] >> (BLUE - lamp) * Byte.SIZE & FULL_PART;
    }

    /** What comes back from the surface by the light of a lamp, up to 1023; -1 without a sensor. */
    public int level(int lamp) {
        Stimulus stimulus = socket.stimulus();
        return switch (stimulus.kind()) {
            case NONE -> ABSENT;
            case COLOR -> FULL_LEVEL * reflected(stimulus.number(), lamp) / FULL_PART;
            default -> FULL_LEVEL - socket.rawLevel();
        };
    }

    private static int reflected(int color, int lamp) {
        return lamp == ALL
                ? (part(color, RED) + part(color, GREEN) + part(color, BLUE)) / PARTS
                : part(color, lamp);
    }
}

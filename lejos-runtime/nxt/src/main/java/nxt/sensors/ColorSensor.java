package nxt.sensors;

import lejos.nxt.SensorPort;

/** Platform component nxt.ColorSensor on the brick. */
public final class ColorSensor {
    /** Code of nxt.Brick.Color. */
    public int color = NONE;

    /** The constants of nxt.Brick.Color in their order. */
    private static final int NONE = 1;

    private static final int BLACK = 2;
    private static final int BLUE = 3;
    private static final int GREEN = 4;
    private static final int YELLOW = 5;
    private static final int RED = 6;
    private static final int WHITE = 7;

    private final lejos.nxt.ColorSensor device;

    public ColorSensor(int socket) {
        device = new lejos.nxt.ColorSensor(SensorPort.getInstance(socket - 1));
    }

    /** Samples the device: the start of a slice. */
    public void sense() {
        color = code(device.getColorID());
    }

    private static int code(int id) {
        switch (id) {
            case lejos.robotics.Color.BLACK:
                return BLACK;
            case lejos.robotics.Color.BLUE:
                return BLUE;
            case lejos.robotics.Color.GREEN:
                return GREEN;
            case lejos.robotics.Color.YELLOW:
                return YELLOW;
            case lejos.robotics.Color.RED:
                return RED;
            case lejos.robotics.Color.WHITE:
                return WHITE;
            default:
                return NONE;
        }
    }
}

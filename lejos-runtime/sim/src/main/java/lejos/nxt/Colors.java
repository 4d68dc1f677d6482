package lejos.nxt;

import arcomat.sim.device.ColorEye;

import lejos.robotics.Color;

/** How the colour sensor itself numbers colours, and its lamp. */
final class Colors implements SensorConstants {
    private static final int[] BY_NUMBER = {
        Color.NONE, Color.BLACK, Color.BLUE, Color.GREEN, Color.YELLOW, Color.RED, Color.WHITE
    };

    private Colors() {}

    /** Names by the sensor's numbers. */
    static int[] byNumber() {
        return BY_NUMBER.clone();
    }

    /** The sensor's number of a colour; -1 for one that it does not know. */
    static int ofSensor(int color) {
        for (int number = BLACK; number < BY_NUMBER.length; number++) {
            if (BY_NUMBER[number] == color) {
                return number;
            }
        }
        return -1;
    }

    /** The lamp of a type of the port. */
    static int lamp(int type) {
        return switch (type) {
            case TYPE_COLORRED -> ColorEye.RED;
            case TYPE_COLORGREEN -> ColorEye.GREEN;
            case TYPE_COLORBLUE -> ColorEye.BLUE;
            case TYPE_COLORNONE -> ColorEye.DARK;
            default -> ColorEye.ALL;
        };
    }
}

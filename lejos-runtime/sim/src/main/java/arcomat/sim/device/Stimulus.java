package arcomat.sim.device;

/**
 * What a sensor is exposed to.
 *
 * @param kind how the number is meant
 * @param number distance in cm, brightness or loudness in percent of the full scale, 1 for pressed,
 *     a colour's number, or the raw value of the analogue converter
 */
public record Stimulus(Kind kind, int number) {
    /** How a number is meant. */
    public enum Kind {
        /** Nothing is plugged in. */
        NONE,
        /** In the unit of the sensor, whichever that is. */
        VALUE,
        /** A switch, pressed or not. */
        SWITCH,
        /** A colour. */
        COLOR,
        /** As the analogue converter sees it: 0 is bright, loud, pressed; 1023 the contrary. */
        RAW
    }

    public static final Stimulus NONE = new Stimulus(Kind.NONE, 0);

    public static Stimulus value(int number) {
        return new Stimulus(Kind.VALUE, number);
    }

    public static Stimulus pressed(boolean isPressed) {
        return new Stimulus(Kind.SWITCH, isPressed ? 1 : 0);
    }

    public static Stimulus color(int number) {
        return new Stimulus(Kind.COLOR, number);
    }

    public static Stimulus raw(int number) {
        return new Stimulus(Kind.RAW, number);
    }
}

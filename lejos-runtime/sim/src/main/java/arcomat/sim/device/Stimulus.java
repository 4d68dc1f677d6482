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
        /** In the unit of the sensor. */
        VALUE,
        /** As the analogue converter sees it: 0 is bright, loud, pressed; 1023 the contrary. */
        RAW
    }

    public static final Stimulus NONE = new Stimulus(Kind.NONE, 0);

    public static Stimulus value(int number) {
        return new Stimulus(Kind.VALUE, number);
    }

    public static Stimulus raw(int number) {
        return new Stimulus(Kind.RAW, number);
    }
}

package arcomat.campaign.statistics;

/**
 * How sure one has to be.
 *
 * @param level how often a statement of this kind is right at least, over many campaigns; between 0
 *     and 1, such as 0.95
 */
public record Confidence(double level) {
    /** Where nobody says another one. */
    public static final Confidence USUAL = new Confidence(0.95);

    public Confidence {
        if (!(level > 0 && level < 1)) {
            throw new IllegalArgumentException("confidence " + level + " is not between 0 and 1");
        }
    }

    /** How often it may be wrong. */
    public double error() {
        return 1 - level;
    }

    /** For one side of two: together they are as sure as this. */
    Confidence ofEachSide() {
        return new Confidence(1 - error() / 2);
    }
}

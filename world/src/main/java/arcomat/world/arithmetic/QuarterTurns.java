package arcomat.world.arithmetic;

/**
 * An angle as quarter turns and a rest, in the way of fdlibm: pi / 2 is taken in parts of 33 bits,
 * of which a multiple is exact.
 *
 * @param count negative for a negative angle
 * @param rest at most an eighth of a turn, about
 * @param error what is missing of the rest
 */
record QuarterTurns(int count, double rest, double error) {
    private static final double PER_RADIAN = 0.6366197723675814;

    /** The parts, and what is left behind each. */
    private static final double[] PART = {
        1.5707963267341256, 6.077100506303966e-11, 2.0222662487111665e-21
    };

    private static final double[] LEFT = {
        6.077100506506192e-11, 2.0222662487959506e-21, 8.4784276603689e-32
    };

    private static final double THREE_EIGHTHS = Circle.bits(0x4002d97c);
    private static final int QUARTER = 0x3ff921fb;

    /** So many bits may be lost before a further part is needed. */
    private static final int[] LOST = {16, 49};

    /** Below so many quarters the upper half of an angle tells whether bits are lost. */
    private static final int FEW = 32;

    static QuarterTurns of(double angle) {
        QuarterTurns turns = ofPositive(Math.abs(angle));
        return angle < 0 ? new QuarterTurns(-turns.count, -turns.rest, -turns.error) : turns;
    }

    private static QuarterTurns ofPositive(double angle) {
        if (angle < THREE_EIGHTHS) {
            return oneOf(angle);
        }
        int count = (int) (angle * PER_RADIAN + 0.5);
        double rest = angle - count * PART[0];
        double left = count * LEFT[0];
        double sum = rest - left;
        if (count < FEW && upper(angle) != upper(count * (Math.PI / 2))) {
            return new QuarterTurns(count, sum, rest - sum - left);
        }
        for (int i = 0; i < LOST.length && lost(angle, sum) > LOST[i]; i++) {
            double before = rest;
            double part = count * PART[i + 1];
            rest = before - part;
            left = count * LEFT[i + 1] - (before - rest - part);
            sum = rest - left;
        }
        return new QuarterTurns(count, sum, rest - sum - left);
    }

    private static QuarterTurns oneOf(double angle) {
        double rest = angle - PART[0];
        double left = LEFT[0];
        if (upper(angle) == QUARTER) {
            rest -= PART[1];
            left = LEFT[1];
        }
        double sum = rest - left;
        return new QuarterTurns(1, sum, rest - sum - left);
    }

    private static int lost(double angle, double rest) {
        return exponent(angle) - exponent(rest);
    }

    private static int exponent(double x) {
        return upper(x) >> 20 & 0x7ff;
    }

    private static int upper(double x) {
        return (int) (Double.doubleToLongBits(x) >>> 32);
    }
}

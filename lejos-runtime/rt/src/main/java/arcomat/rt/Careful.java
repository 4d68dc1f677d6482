package arcomat.rt;

/**
 * The operations of {@link Check} where a way to go on is only tried: what goes wrong is noted, and
 * told if anybody asks. No exception is made for it. What comes after the first mistake does not
 * count any more, so that any result will do.
 */
public final class Careful {
    private static final int NOTHING = 0;
    private static final int DIVISION = 1;
    private static final int INT = 2;
    private static final int LONG = 3;
    private static final int SHORT = 4;
    private static final int BYTE = 5;

    private int mistake;
    private long value;
    private long low;
    private long high;
    private String place;

    Careful() {}

    void forget() {
        mistake = NOTHING;
    }

    boolean isWrong() {
        return mistake != NOTHING;
    }

    void become(Careful that) {
        mistake = that.mistake;
        value = that.value;
        low = that.low;
        high = that.high;
        place = that.place;
    }

    private void note(int kind, long wrong, long lowest, long highest, String where) {
        if (mistake == NOTHING) {
            mistake = kind;
            value = wrong;
            low = lowest;
            high = highest;
            place = where;
        }
    }

    private long ranged(int kind, long given, long lowest, long highest, String where) {
        if (given < lowest || given > highest) {
            note(kind, given, lowest, highest, where);
        }
        return given;
    }

    public int range(int given, int lowest, int highest, String where) {
        return (int) ranged(INT, given, lowest, highest, where);
    }

    public long range(long given, long lowest, long highest, String where) {
        return ranged(LONG, given, lowest, highest, where);
    }

    public int shortRange(int given, int lowest, int highest, String where) {
        return (int) ranged(SHORT, given, lowest, highest, where);
    }

    public int byteRange(int given, int lowest, int highest, String where) {
        return (int) ranged(BYTE, given, lowest, highest, where);
    }

    public int divide(int dividend, int divisor, String where) {
        return isZero(divisor, where) ? 0 : dividend / divisor;
    }

    public long divide(long dividend, long divisor, String where) {
        return isZero(divisor, where) ? 0 : dividend / divisor;
    }

    public int remainder(int dividend, int divisor, String where) {
        return isZero(divisor, where) ? 0 : dividend % divisor;
    }

    public long remainder(long dividend, long divisor, String where) {
        return isZero(divisor, where) ? 0 : dividend % divisor;
    }

    private boolean isZero(long divisor, String where) {
        if (divisor == 0) {
            note(DIVISION, 0, 0, 0, where);
        }
        return divisor == 0;
    }

    /** What went wrong, in the words of {@link Check}. */
    String text() {
        try {
            again();
            return "";
        } catch (ModelError e) {
            return e.getMessage();
        }
    }

    private void again() {
        switch (mistake) {
            case DIVISION:
                Check.divide(0, 0, place);
                break;
            case INT:
                Check.range((int) value, (int) low, (int) high, place);
                break;
            case LONG:
                Check.range(value, low, high, place);
                break;
            case SHORT:
                Check.shortRange((int) value, (int) low, (int) high, place);
                break;
            case BYTE:
                Check.byteRange((int) value, (int) low, (int) high, place);
                break;
            default:
                break;
        }
    }
}

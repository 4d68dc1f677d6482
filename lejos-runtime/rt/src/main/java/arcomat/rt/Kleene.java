package arcomat.rt;

/**
 * Kleene's connectives over what is known of conditions that nest deeply. A number says two things
 * of a condition: what came out when it was looked at as far as it may be true, and what came out
 * as far as it may be false. Either is that it is so, that it is not, or that it goes wrong; where
 * neither is so, the condition is undefined. So each part is looked at once, and what goes wrong
 * counts only where a look from left to right comes to it.
 */
public final class Kleene {
    /** It is neither true nor false, since a message is missing. */
    public static final int UNDEFINED = 0;

    public static final int TRUE = 1;

    public static final int FALSE = 4;

    /** Looking at it, or asking whether it is defined, divides by zero. */
    public static final int WRONG = 10;

    /** It is defined, and looking at it divides by zero. */
    public static final int DEFINED_WRONG = 26;

    /** Selects what came out as far as it may be true; the bits above it say the same of false. */
    private static final int TRUTH = 3;

    private static final int FALSEHOOD = 12;

    private Kleene() {}

    /** Returns what is known of a condition that has a value. */
    public static int of(boolean value) {
        return value ? TRUE : FALSE;
    }

    /** The contrary. */
    public static int not(int a) {
        return a == DEFINED_WRONG ? a : (a & TRUTH) << 2 | a >> 2;
    }

    /** Both: the second one counts where the first one does not decide. */
    public static int and(int a, int b) {
        return ((a & TRUTH) == TRUE ? b & TRUTH : a & TRUTH)
                | ((a & FALSEHOOD) == 0 ? b & FALSEHOOD : a & FALSEHOOD);
    }

    /** One of them: the second one counts where the first one does not decide. */
    public static int or(int a, int b) {
        return ((a & TRUTH) == 0 ? b & TRUTH : a & TRUTH)
                | ((a & FALSEHOOD) == FALSE ? b & FALSEHOOD : a & FALSEHOOD);
    }

    /** Whether both have the same value; first it is asked whether they have one. */
    public static int equal(int a, int b) {
        int left = value(a);
        if (left == UNDEFINED || left == WRONG) {
            return left;
        }
        int right = value(b);
        if (right == UNDEFINED || right == WRONG) {
            return right;
        }
        return left == DEFINED_WRONG || right == DEFINED_WRONG ? DEFINED_WRONG : of(left == right);
    }

    /** Returns what is known of one of two conditions, as another one decides. */
    public static int choose(int condition, int then, int otherwise) {
        int decides = value(condition);
        if (decides == TRUE) {
            return then;
        }
        return decides == FALSE ? otherwise : decides & WRONG;
    }

    /** All that it is, looked at as far as it may be true first. */
    private static int value(int a) {
        if (a == DEFINED_WRONG) {
            return a;
        }
        int truth = a & TRUTH;
        if (truth == TRUE) {
            return TRUE;
        }
        return truth == 0 && (a == UNDEFINED || a == FALSE) ? a : WRONG;
    }

    /** Whether it goes wrong to look at it as far as it may be true. */
    public static boolean isWrong(int a) {
        return (a & TRUTH) == (WRONG & TRUTH);
    }

    /** Whether it is true, or goes wrong at a place. */
    public static boolean isTrue(int a, String place) {
        if (isWrong(a)) {
            throw Check.byZero(place);
        }
        return (a & TRUTH) == TRUE;
    }
}

package arcomat.live.browser;

/**
 * Divides whole numbers as Java does, where WebAssembly would end everything: by nothing, and the
 * least number by -1.
 */
public final class Division {
    private Division() {}

    /**
     * @throws ArithmeticException if the divisor is 0
     */
    public static int quotient(int dividend, int divisor) {
        return divisor == -1 ? -dividend : dividend / notNothing(divisor);
    }

    /**
     * @throws ArithmeticException if the divisor is 0
     */
    public static long quotient(long dividend, long divisor) {
        return divisor == -1 ? -dividend : dividend / notNothing(divisor);
    }

    /**
     * @throws ArithmeticException if the divisor is 0
     */
    public static int remainder(int dividend, int divisor) {
        return dividend % notNothing(divisor);
    }

    /**
     * @throws ArithmeticException if the divisor is 0
     */
    public static long remainder(long dividend, long divisor) {
        return dividend % notNothing(divisor);
    }

    private static int notNothing(int divisor) {
        if (divisor == 0) {
            throw new ArithmeticException("/ by zero");
        }
        return divisor;
    }

    private static long notNothing(long divisor) {
        if (divisor == 0) {
            throw new ArithmeticException("/ by zero");
        }
        return divisor;
    }
}

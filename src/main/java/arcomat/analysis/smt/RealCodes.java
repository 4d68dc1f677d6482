package arcomat.analysis.smt;

import arcomat.model.Type;

import de.uni_freiburg.informatik.ultimate.logic.Term;

/**
 * The numbers of IEEE 754 as integers in the same order: the positive ones by their bits, the
 * negative ones as the opposite. Beyond the infinities stand what is no number, and the negative
 * zero, which is another message than zero, and compared like it.
 *
 * @param infinity its code
 * @param single whether they have 32 bits
 */
record RealCodes(long infinity, boolean single) {
    private static final RealCodes DOUBLES =
            new RealCodes(Double.doubleToRawLongBits(Double.POSITIVE_INFINITY), false);
    private static final RealCodes FLOATS =
            new RealCodes(Float.floatToRawIntBits(Float.POSITIVE_INFINITY), true);

    static RealCodes of(Type.RealType type) {
        return type.single() ? FLOATS : DOUBLES;
    }

    private long notANumber() {
        return infinity + 1;
    }

    private long negativeZero() {
        return infinity + 2;
    }

    long least() {
        return -infinity;
    }

    long most() {
        return negativeZero();
    }

    /** The code of a number that the type has. */
    long code(double number) {
        if (Double.isNaN(number)) {
            return notANumber();
        }
        if (number == 0) {
            return 1 / number < 0 ? negativeZero() : 0;
        }
        double size = Math.abs(number);
        long bits =
                single ? Float.floatToRawIntBits((float) size) : Double.doubleToRawLongBits(size);
        return number < 0 ? -bits : bits;
    }

    /** The number that has a code. */
    double real(long code) {
        if (code == notANumber()) {
            return Double.NaN;
        }
        if (code == negativeZero()) {
            return -0.0;
        }
        long bits = Math.abs(code);
        double size = single ? Float.intBitsToFloat((int) bits) : Double.longBitsToDouble(bits);
        return code < 0 ? -size : size;
    }

    /** A comparison, by the sign that models and SMT-LIB write: all but a number is unequal. */
    Term compared(String sign, Term one, Term two, Solver solver) {
        return solver.and(
                isNumber(one, solver),
                isNumber(two, solver),
                solver.apply(sign, place(one, solver), place(two, solver)));
    }

    Term negated(Term code, Solver solver) {
        return solver.choose(
                solver.not(isNumber(code, solver)),
                code,
                solver.choose(
                        solver.equal(code, solver.number(0)),
                        solver.number(negativeZero()),
                        solver.apply("-", place(code, solver))));
    }

    private Term isNumber(Term code, Solver solver) {
        return solver.not(solver.equal(code, solver.number(notANumber())));
    }

    private Term place(Term code, Solver solver) {
        return solver.choose(
                solver.equal(code, solver.number(negativeZero())), solver.number(0), code);
    }
}

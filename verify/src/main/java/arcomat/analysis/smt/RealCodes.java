package arcomat.analysis.smt;

import arcomat.analysis.bits.RealFormat;
import arcomat.model.Type;

import de.uni_freiburg.informatik.ultimate.logic.Term;

/**
 * The numbers of IEEE 754 as integers in the same order: their {@linkplain RealFormat#place
 * places}. Beyond the infinities stand what is no number, and the negative zero, which is another
 * message than zero, and compared like it.
 */
record RealCodes(RealFormat format) {
    static RealCodes of(Type.RealType type) {
        return new RealCodes(RealFormat.of(type));
    }

    private long notANumber() {
        return format.infinity() + 1;
    }

    private long negativeZero() {
        return format.infinity() + 2;
    }

    long least() {
        return -format.infinity();
    }

    long most() {
        return negativeZero();
    }

    /** The code of a number that the type has. */
    long code(double number) {
        if (Double.isNaN(number)) {
            return notANumber();
        }
        return number == 0 && 1 / number < 0 ? negativeZero() : format.place(number);
    }

    /** The number that has a code. */
    double real(long code) {
        if (code == notANumber()) {
            return Double.NaN;
        }
        return code == negativeZero() ? -0.0 : format.atPlace(code);
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

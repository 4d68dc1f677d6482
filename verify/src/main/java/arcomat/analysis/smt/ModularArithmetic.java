package arcomat.analysis.smt;

import arcomat.model.Expression;
import arcomat.semantics.expression.Interval;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.math.BigInteger;

/**
 * Integers that wrap around: a result that does not fit its type is the number that fits and is
 * some turns away, each as long as the type has numbers.
 */
record ModularArithmetic(ReadTerms at, Solver solver) {
    /** More turns are not told apart one by one. */
    private static final int CASES = 1;

    /**
     * Of the numbers that fit the type of an expression the one that is meant by an exact result.
     */
    Term wrapped(Term exact, Expression e) {
        Interval possible = Interval.unwrapped(e);
        Interval width = Interval.ofWidth(e.type());
        BigInteger least = width.turns(possible.low());
        BigInteger most = width.turns(possible.high());
        boolean few = isFew(least) && isFew(most);
        return few
                ? byCases(exact, width, least.intValueExact(), most.intValueExact())
                : turned(exact, width);
    }

    private static boolean isFew(BigInteger turns) {
        return turns.abs().compareTo(BigInteger.valueOf(CASES)) <= 0;
    }

    private Term byCases(Term exact, Interval width, int least, int most) {
        Term result = turned(exact, width, most);
        for (int turns = most - 1; turns >= least; turns--) {
            BigInteger end = width.high().add(length(width, turns));
            Term fits = solver.apply("<=", exact, solver.number(end));
            result = solver.choose(fits, turned(exact, width, turns), result);
        }
        return result;
    }

    private static BigInteger length(Interval width, int turns) {
        return width.size().multiply(BigInteger.valueOf(turns));
    }

    private Term turned(Term exact, Interval width, int turns) {
        return turns == 0 ? exact : solver.apply("-", exact, solver.number(length(width, turns)));
    }

    /** As often as it takes. */
    private Term turned(Term exact, Interval width) {
        Term result = at.defined();
        Term all = solver.apply("*", solver.number(width.size()), at.defined());
        solver.claim(solver.equal(exact, solver.apply("+", result, all)));
        solver.claim(solver.between(width.low(), result, width.high()));
        return result;
    }
}

package arcomat.analysis.automaton.trap;

import arcomat.analysis.reachability.Hazard;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;

/**
 * A number that has an end, whichever way it goes: a ranking function. Numbers of a type of Java
 * are finitely many, and what wraps around does not rise.
 *
 * @param value over the variables, a number
 * @param rises whether it gets closer to the end when it rises; else when it falls
 */
record RankingFunction(Expression value, boolean rises) {
    /** Whether a later value is closer to the end. */
    Expression isCloser(Expression later, Expression earlier) {
        return Hazard.compare(rises ? BinaryOperator.GREATER : BinaryOperator.LESS, later, earlier);
    }
}

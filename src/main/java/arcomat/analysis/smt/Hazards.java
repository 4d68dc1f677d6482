package arcomat.analysis.smt;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.semantics.expression.Rewriting;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.util.ArrayList;
import java.util.List;

/**
 * When the evaluation of an expression goes wrong. Connectives are evaluated from the left, and
 * only as far as needed.
 */
final class Hazards {
    private final Translation translation;
    private final Solver solver;

    Hazards(Translation translation, Solver solver) {
        this.translation = translation;
        this.solver = solver;
    }

    /** A divisor is zero. */
    Term divisionByZero(Expression e) {
        return somewhere(e);
    }

    private Term somewhere(Expression e) {
        if (e instanceof Expression.Binary binary && Wraparound.isLazy(binary.operator())) {
            Term left = translation.term(binary.left());
            Term goesOn = binary.operator() == BinaryOperator.OR ? solver.not(left) : left;
            return solver.or(
                    somewhere(binary.left()), solver.and(goesOn, somewhere(binary.right())));
        }
        if (e instanceof Expression.Conditional choice) {
            Term condition = translation.term(choice.condition());
            return solver.or(
                    somewhere(choice.condition()),
                    solver.choose(
                            condition, somewhere(choice.then()), somewhere(choice.otherwise())));
        }
        if (e instanceof Expression.PortMatches matches) {
            return somewhere(matches);
        }
        List<Term> all = new ArrayList<>();
        Rewriting.operands(e).forEach(operand -> all.add(somewhere(operand)));
        all.add(here(e));
        return solver.or(all);
    }

    /** Nothing is computed where there is no message, and nothing behind a value that fits. */
    private Term somewhere(Expression.PortMatches matches) {
        Term before = translation.has(matches.port());
        List<Term> all = new ArrayList<>();
        for (Expression value : Rewriting.operands(matches)) {
            all.add(solver.and(before, somewhere(value)));
            before = solver.and(before, solver.not(translation.fits(matches, value)));
        }
        return solver.or(all);
    }

    private Term here(Expression e) {
        boolean divides =
                e instanceof Expression.Binary binary
                        && (binary.operator() == BinaryOperator.DIVIDE
                                || binary.operator() == BinaryOperator.REMAINDER)
                        && Translation.isInteger(binary.type());
        return divides
                ? solver.equal(translation.term(((Expression.Binary) e).right()), solver.number(0))
                : solver.of(false);
    }
}

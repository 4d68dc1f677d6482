package arcomat.analysis.smt;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.semantics.Rewriting;

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
        return somewhere(e, this::dividesByZero);
    }

    /** A result does not fit the width of its type. */
    Term overflow(Expression e) {
        return somewhere(e, this::overflows);
    }

    private interface Local {
        Term in(Expression e);
    }

    private Term somewhere(Expression e, Local local) {
        if (e instanceof Expression.Binary binary && isLazy(binary.operator())) {
            Term left = translation.term(binary.left());
            Term goesOn = binary.operator() == BinaryOperator.OR ? solver.not(left) : left;
            return solver.or(
                    somewhere(binary.left(), local),
                    solver.and(goesOn, somewhere(binary.right(), local)));
        }
        if (e instanceof Expression.Conditional choice) {
            Term condition = translation.term(choice.condition());
            return solver.or(
                    somewhere(choice.condition(), local),
                    solver.choose(
                            condition,
                            somewhere(choice.then(), local),
                            somewhere(choice.otherwise(), local)));
        }
        List<Term> all = new ArrayList<>();
        Rewriting.operands(e).forEach(operand -> all.add(somewhere(operand, local)));
        all.add(local.in(e));
        return solver.or(all);
    }

    private static boolean isLazy(BinaryOperator operator) {
        return operator == BinaryOperator.AND
                || operator == BinaryOperator.OR
                || operator == BinaryOperator.IMPLIES;
    }

    private Term dividesByZero(Expression e) {
        boolean divides =
                e instanceof Expression.Binary binary
                        && (binary.operator() == BinaryOperator.DIVIDE
                                || binary.operator() == BinaryOperator.REMAINDER)
                        && Translation.isInteger(binary.type());
        return divides
                ? solver.equal(translation.term(((Expression.Binary) e).right()), solver.number(0))
                : solver.of(false);
    }

    private Term overflows(Expression e) {
        boolean computes =
                e instanceof Expression.Binary
                        || e instanceof Expression.Unary
                        || e instanceof Expression.Cast cast
                                && Translation.isInteger(cast.operand().type());
        if (!computes || !(e.type() instanceof Type.IntegerType integer)) {
            return solver.of(false);
        }
        Type.IntegerType width = Type.IntegerType.of(integer.width());
        if (e instanceof Expression.Binary binary) {
            if (binary.operator() == BinaryOperator.REMAINDER) {
                return solver.of(false);
            }
            if (binary.operator() == BinaryOperator.DIVIDE) {
                return overflows(binary, width);
            }
        }
        return solver.not(solver.between(width.low(), translation.term(e), width.high()));
    }

    /** There is one quotient that does not fit: that of the lowest number and -1. */
    private Term overflows(Expression.Binary division, Type.IntegerType width) {
        return solver.and(
                solver.equal(translation.term(division.left()), solver.number(width.low())),
                solver.equal(translation.term(division.right()), solver.number(-1)));
    }
}

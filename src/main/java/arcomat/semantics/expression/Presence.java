package arcomat.semantics.expression;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.HashSet;
import java.util.Set;

/**
 * What is known of expressions at a place where some ports carry a message for certain. Its
 * two-valued conditions are those of {@link Guards}, without what is known.
 */
public final class Presence {
    private final Formulas formulas;
    private final Guards guards;

    public Presence(Component.Profile profile) {
        this.formulas = new Formulas(profile);
        this.guards = new Guards(profile);
    }

    /** Names of the ports that an expression reads and that may be silent. */
    public Set<String> open(Expression expression, Set<String> present) {
        Set<String> open = new HashSet<>();
        expression.visit(
                e -> {
                    if (e instanceof Expression.PortRead read
                            && formulas.mayBeAbsent(read.port())
                            && !present.contains(read.port().name())) {
                        open.add(read.port().name());
                    }
                });
        return open;
    }

    /** That all ports that an expression reads carry a message. */
    public Expression present(Expression expression, Set<String> present) {
        return formulas.simplify(formulas.present(expression), present);
    }

    /** Both conditions, without tests of presence that hold by what stands before them. */
    public Expression both(Expression first, Expression second) {
        return formulas.simplify(Formulas.and(first, second));
    }

    /** A condition without tests of presence that hold at this place. */
    public Expression simplify(Expression condition, Set<String> present) {
        return formulas.simplify(condition, present);
    }

    /** Whether an expression has a value just where all ports that it reads carry a message. */
    public boolean isStrict(Expression expression) {
        return formulas.isStrict(expression);
    }

    /** That a condition has a value, and that it is this one. */
    public Expression certainly(boolean truth, Expression condition, Set<String> present) {
        Expression wanted = truth ? condition : negation(condition);
        return formulas.simplify(guards.isTrue(wanted), present);
    }

    private static Expression negation(Expression e) {
        return new Expression.Unary(Expression.UnaryOperator.NOT, e, e.type(), e.span());
    }

    /** Whether an expression has a value in any case, as Java computes it from left to right. */
    public boolean isDefined(Expression e, Set<String> present) {
        if (open(e, present).isEmpty()) {
            return true;
        }
        if (e instanceof Expression.Conditional choice) {
            return isDefined(choice.condition(), present)
                    && isDefined(choice.then(), where(true, choice.condition(), present))
                    && isDefined(choice.otherwise(), where(false, choice.condition(), present));
        }
        if (e instanceof Expression.Binary binary && Formulas.isLazy(e)) {
            boolean whereTrue = binary.operator() != BinaryOperator.OR;
            return isDefined(binary.left(), present)
                    && isDefined(binary.right(), where(whereTrue, binary.left(), present));
        }
        return e.operands().stream().allMatch(operand -> isDefined(operand, present))
                && !e.operands().isEmpty();
    }

    /**
     * The ports that carry a message for certain where a condition has a value.
     *
     * @param truth the value
     */
    public Set<String> where(boolean truth, Expression condition, Set<String> present) {
        Set<String> known = new HashSet<>(present);
        add(truth, condition, known);
        return known;
    }

    private void add(boolean truth, Expression e, Set<String> known) {
        if (e instanceof Expression.PortMatches matches) {
            boolean absent = matches.pattern() instanceof Automaton.Absent;
            boolean tells = truth || !(matches.pattern() instanceof Automaton.OneOf);
            if (truth != absent && tells) {
                known.add(matches.port().name());
            }
        } else if (Formulas.isNegation(e)) {
            add(!truth, e.operands().get(0), known);
        } else if (formulas.isStrict(e) && !open(e, known).isEmpty()) {
            known.addAll(open(e, known));
        } else if (e instanceof Expression.Binary binary) {
            boolean both = binary.operator() == BinaryOperator.AND && truth;
            boolean neither = binary.operator() == BinaryOperator.OR && !truth;
            if (both || neither) {
                add(truth, binary.left(), known);
                add(truth, binary.right(), known);
            } else if (binary.operator() == BinaryOperator.IMPLIES && !truth) {
                add(true, binary.left(), known);
                add(false, binary.right(), known);
            }
        }
    }

    /** Whether computing an expression may go wrong. */
    public static boolean mayFail(Expression expression) {
        return expression.contains(
                e -> e instanceof Expression.Binary binary && mayDivideByZero(binary));
    }

    /** Whether the right operand may be a whole number that is zero. */
    public static boolean mayDivideByZero(Expression.Binary binary) {
        return binary.operator().divides()
                && binary.left().type() instanceof Type.IntegerType
                && !isNonZero(binary.right());
    }

    private static boolean isNonZero(Expression e) {
        return e instanceof Expression.Constant constant
                && constant.value() instanceof Value.IntegerValue integer
                && integer.value() != 0;
    }
}

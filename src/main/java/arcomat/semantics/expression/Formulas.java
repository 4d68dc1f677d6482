package arcomat.semantics.expression;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Expression.UnaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/** The logic under {@link Guards}: connectives that fold, tests of presence, simplification. */
public final class Formulas {
    private static final Type BOOLEAN = new Type.BooleanType();
    public static final Expression TRUE = constant(true);
    public static final Expression FALSE = constant(false);

    private final Component.Profile profile;

    Formulas(Component.Profile profile) {
        this.profile = profile;
    }

    @SuppressWarnings("NullAway") // it stands nowhere in the text
    private static Expression constant(boolean value) {
        return new Expression.Constant(new Value.BooleanValue(value), BOOLEAN, null);
    }

    /** Both, as far as that is not known. */
    public static Expression and(Expression left, Expression right) {
        if (isConstant(left, true)) {
            return right;
        }
        if (isConstant(right, true) || isConstant(left, false)) {
            return left;
        }
        return new Expression.Binary(BinaryOperator.AND, left, right, BOOLEAN, left.span());
    }

    /** One of them, as far as that is not known. */
    public static Expression or(Expression left, Expression right) {
        if (isConstant(left, false)) {
            return right;
        }
        if (isConstant(right, false) || isConstant(left, true)) {
            return left;
        }
        return new Expression.Binary(BinaryOperator.OR, left, right, BOOLEAN, left.span());
    }

    /** Its contrary. */
    public static Expression not(Expression e) {
        if (isConstant(e, true) || isConstant(e, false)) {
            return isConstant(e, true) ? FALSE : TRUE;
        }
        if (isNegation(e)) {
            return e.operands().get(0);
        }
        if (e instanceof Expression.PortMatches matches) {
            if (matches.pattern() instanceof Automaton.Absent) {
                return present(matches.port(), matches);
            }
            if (matches.pattern() instanceof Automaton.Present) {
                return new Expression.PortMatches(
                        matches.port(), new Automaton.Absent(), matches.span());
            }
        }
        if (e instanceof Expression.Binary binary) {
            if (binary.operator() == BinaryOperator.EQUAL) {
                return with(binary, BinaryOperator.NOT_EQUAL);
            }
            if (binary.operator() == BinaryOperator.NOT_EQUAL) {
                return with(binary, BinaryOperator.EQUAL);
            }
        }
        return new Expression.Unary(UnaryOperator.NOT, e, BOOLEAN, e.span());
    }

    /** The same, with a negation at the top carried out. */
    static Expression folded(Expression e) {
        return isNegation(e) ? not(e.operands().get(0)) : e;
    }

    static boolean isNegation(Expression e) {
        return e instanceof Expression.Unary unary && unary.operator() == UnaryOperator.NOT;
    }

    private static Expression with(Expression.Binary binary, BinaryOperator operator) {
        return new Expression.Binary(
                operator, binary.left(), binary.right(), BOOLEAN, binary.span());
    }

    private static boolean isConstant(Expression e, boolean value) {
        return e instanceof Expression.Constant constant
                && constant.value().equals(new Value.BooleanValue(value));
    }

    /** Whether a connective may have a value although an operand has none. */
    static boolean isLazy(Expression e) {
        if (e instanceof Expression.Binary binary) {
            return binary.operator().isLazy();
        }
        return isNegation(e) && isLazy(e.operands().get(0));
    }

    /** Whether an expression has a value just where all ports that it reads carry a message. */
    boolean isStrict(Expression expression) {
        return !expression.contains(
                        e ->
                                isLazy(e)
                                        || e instanceof Expression.Conditional
                                        || e instanceof Expression.PortMatches)
                || !expression.contains(this::mayBeUndefined);
    }

    /** Whether an expression is the message of a port that may carry none. */
    boolean mayBeUndefined(Expression e) {
        return e instanceof Expression.PortRead read && mayBeAbsent(read.port());
    }

    /** That all ports that an expression reads carry a message. */
    Expression present(Expression expression) {
        Map<String, Expression> tests = new LinkedHashMap<>();
        expression.visit(
                e -> {
                    if (e instanceof Expression.PortRead read && mayBeAbsent(read.port())) {
                        tests.putIfAbsent(read.port().name(), present(read.port(), e));
                    }
                });
        return tests.values().stream().reduce(TRUE, Formulas::and);
    }

    private static Expression present(Port port, Expression because) {
        return new Expression.PortMatches(port, new Automaton.Present(), because.span());
    }

    /** Whether a port may carry no message. */
    boolean mayBeAbsent(Port port) {
        return profile.mayBeSilent(port);
    }

    /** Drops tests of presence that hold by what stands before them. */
    Expression simplify(Expression expression) {
        return simplify(expression, new HashSet<>());
    }

    /**
     * As above.
     *
     * @param present names of ports that carry a message for certain
     */
    Expression simplify(Expression e, Set<String> present) {
        if (e instanceof Expression.PortMatches matches) {
            boolean certain =
                    present.contains(matches.port().name()) || !mayBeAbsent(matches.port());
            if (certain && matches.pattern() instanceof Automaton.Present) {
                return TRUE;
            }
            return certain && matches.pattern() instanceof Automaton.Absent ? FALSE : e;
        }
        if (e instanceof Expression.Binary binary) {
            if (binary.operator() == BinaryOperator.AND) {
                Expression left = simplify(binary.left(), present);
                Set<String> known = new HashSet<>(present);
                addPorts(left, known);
                return and(left, simplify(binary.right(), known));
            }
            if (binary.operator() == BinaryOperator.OR) {
                return or(simplify(binary.left(), present), simplify(binary.right(), present));
            }
        }
        return e;
    }

    /** The ports that carry a message where the condition holds. */
    private static void addPorts(Expression condition, Set<String> present) {
        if (condition instanceof Expression.PortMatches matches
                && !(matches.pattern() instanceof Automaton.Absent)) {
            present.add(matches.port().name());
        }
        if (condition instanceof Expression.Binary binary
                && binary.operator() == BinaryOperator.AND) {
            addPorts(binary.left(), present);
            addPorts(binary.right(), present);
        }
    }
}

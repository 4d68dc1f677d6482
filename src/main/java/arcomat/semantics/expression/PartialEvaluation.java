package arcomat.semantics.expression;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Computes as much of a condition as some of the messages tell: what is left reads the others only
 * (Jones, Gomard, Sestoft, "Partial Evaluation and Automatic Program Generation", 1993). A
 * condition is one of {@link Guards}, which reads only ports whose presence it has tested. Where
 * nothing goes wrong in it, what is left has the same value.
 *
 * @param known messages by the name of their port; a port that is not named, and not open either,
 *     carries none
 * @param open names of ports with a message that nobody knows
 */
public record PartialEvaluation(Map<String, Value> known, Set<String> open)
        implements Expression.SomeCases<Expression> {
    private static final Scope NO_NAMES = Scope.ofParameters(List.of(), List.of());

    public PartialEvaluation {
        known = Map.copyOf(known);
        open = Set.copyOf(open);
    }

    /** What is left of an expression that reads no variables and no parameters. */
    public Expression of(Expression expression) {
        return expression.rewritten(each -> each.match(this));
    }

    /** All that it knows of a port: its message, else whether there is one. */
    public Object knowledge(String port) {
        Value message = known.get(port);
        return message == null ? open.contains(port) : message;
    }

    /** The value of an expression of which nothing is left; empty where it has none. */
    public static Optional<Value> value(Expression left) {
        return left instanceof Expression.Constant constant
                ? Optional.of(constant.value())
                : Optional.empty();
    }

    /** A silent port is read only where that does not count: any message will do. */
    @Override
    public Expression portRead(Expression.PortRead read) {
        if (open.contains(read.port().name())) {
            return read;
        }
        Value message = known.get(read.port().name());
        return constant(message == null ? read.type().first() : message, read);
    }

    @Override
    public Expression binary(Expression.Binary binary) {
        return Formulas.isLazy(binary) ? connective(binary) : otherwise(binary);
    }

    @Override
    public Expression conditional(Expression.Conditional choice) {
        return decided(choice);
    }

    /** One of its branches, where its condition has a value. */
    static Expression decided(Expression.Conditional choice) {
        return value(choice.condition())
                .map(decided -> isTrue(decided) ? choice.then() : choice.otherwise())
                .orElse(choice);
    }

    /** Operands have been computed already. */
    @Override
    public Expression otherwise(Expression e) {
        return folded(e);
    }

    /** Its value, where all of its operands have one. */
    static Expression folded(Expression e) {
        boolean closed =
                !e.operands().isEmpty()
                        && e.operands().stream().allMatch(each -> value(each).isPresent());
        return closed ? computed(e) : e;
    }

    /** An operand that decides does so wherever it stands. */
    static Expression connective(Expression.Binary binary) {
        Expression left =
                binary.operator() == BinaryOperator.IMPLIES
                        ? Formulas.not(binary.left())
                        : binary.left();
        boolean and = binary.operator() == BinaryOperator.AND;
        if (value(binary.right()).equals(Optional.of(new Value.BooleanValue(!and)))) {
            return binary.right();
        }
        return and ? Formulas.and(left, binary.right()) : Formulas.or(left, binary.right());
    }

    @Override
    public Expression portMatches(Expression.PortMatches matches) {
        Port port = matches.port();
        Value message = known.get(port.name());
        boolean present = message != null || open.contains(port.name());
        return matches.pattern()
                .match(
                        oneOf -> {
                            if (!present) {
                                return Formulas.FALSE;
                            }
                            return message == null
                                    ? matches
                                    : among(constant(message, port), oneOf, matches);
                        },
                        () -> truth(!present),
                        () -> truth(present));
    }

    /** The values are compared from the left, and only as far as needed. */
    static Expression among(
            Expression read, Automaton.OneOf oneOf, Expression.PortMatches matches) {
        Expression any = Formulas.FALSE;
        for (int i = oneOf.values().size() - 1; i >= 0; i--) {
            Expression equal =
                    folded(
                            new Expression.Binary(
                                    BinaryOperator.EQUAL,
                                    read,
                                    oneOf.values().get(i),
                                    new Type.BooleanType(),
                                    matches.span()));
            any = Formulas.or(equal, any);
        }
        return any;
    }

    /** Unchanged where it goes wrong: that is somebody else's business. */
    private static Expression computed(Expression e) {
        try {
            Value value = NO_NAMES.value(e, new Value[0]);
            return value == null ? e : new Expression.Constant(value, e.type(), e.span());
        } catch (Fault wrong) {
            return e;
        }
    }

    private static Expression truth(boolean value) {
        return value ? Formulas.TRUE : Formulas.FALSE;
    }

    private static boolean isTrue(Value truth) {
        return ((Value.BooleanValue) truth).value();
    }

    private static Expression constant(Value message, Expression.PortRead read) {
        return new Expression.Constant(message, read.type(), read.span());
    }

    private static Expression constant(Value message, Port port) {
        return new Expression.Constant(message, port.type(), port.span());
    }
}

package arcomat.generate.text;

import arcomat.generate.language.Text;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Expression.UnaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.List;
import java.util.Optional;

/** Makes formulas of the two-valued conditions that {@code semantics.Guards} gives. */
public final class FormulaBuilder implements Expression.Cases<Formula> {
    private final ExpressionWriter text;
    private final Simplification simplification;

    public FormulaBuilder(ExpressionWriter text) {
        this.text = text;
        this.simplification = new Simplification(text::mayBeAbsent);
    }

    public Formula of(Expression e) {
        return e.match(this);
    }

    private Formula test(Expression e) {
        return Formula.Test.of(text.of(e), mayFail(e));
    }

    private boolean mayFail(Expression e) {
        return text.checks().areNeeded(e, e.type());
    }

    @Override
    public Formula constant(Expression.Constant constant) {
        return constant.value() instanceof Value.BooleanValue truth
                ? Formula.of(truth.value())
                : test(constant);
    }

    @Override
    public Formula portRead(Expression.PortRead read) {
        return is(read, true, read, Optional.of(new Value.BooleanValue(true)));
    }

    @Override
    public Formula variableRead(Expression.VariableRead read) {
        return test(read);
    }

    @Override
    public Formula parameterRead(Expression.ParameterRead read) {
        return test(read);
    }

    @Override
    public Formula attributeRead(Expression.AttributeRead read) {
        return test(read);
    }

    @Override
    public Formula portMatches(Expression.PortMatches matches) {
        Port port = matches.port();
        Formula something = new Formula.Carries(port, true);
        return matches.pattern()
                .match(
                        oneOf -> {
                            Expression.PortRead read =
                                    new Expression.PortRead(port, matches.span());
                            List<Formula> values =
                                    oneOf.values().stream().map(v -> is(read, true, v)).toList();
                            return simplification.and(
                                    List.of(something, simplification.or(values)));
                        },
                        () -> simplification.and(List.of(new Formula.Carries(port, false))),
                        () -> simplification.and(List.of(something)));
    }

    @Override
    public Formula unary(Expression.Unary unary) {
        return unary.operator() == UnaryOperator.NOT
                ? simplification.not(of(unary.operand()))
                : test(unary);
    }

    @Override
    public Formula binary(Expression.Binary binary) {
        BinaryOperator operator = binary.operator();
        if (operator == BinaryOperator.AND) {
            return simplification.and(row(binary, operator));
        }
        if (operator == BinaryOperator.OR) {
            return simplification.or(row(binary, operator));
        }
        boolean equality = operator == BinaryOperator.EQUAL || operator == BinaryOperator.NOT_EQUAL;
        if (equality && binary.left() instanceof Expression.PortRead read) {
            return is(read, operator == BinaryOperator.EQUAL, binary.right());
        }
        return binary.left().type() instanceof Type.IntegerType ? comparison(binary) : test(binary);
    }

    @Override
    public Formula conditional(Expression.Conditional conditional) {
        return test(conditional);
    }

    @Override
    public Formula isIn(Expression.IsIn isIn) {
        return test(isIn);
    }

    @Override
    public Formula cast(Expression.Cast cast) {
        return test(cast);
    }

    @Override
    public Formula judged(Expression.Judged judged) {
        return new Formula.Judged(judged, text.place());
    }

    /**
     * Of whole numbers one is less than the other one, or it is not; what is no number is neither.
     */
    private Formula comparison(Expression.Binary binary) {
        String left = text.of(binary.left()).text();
        String right = text.of(binary.right()).text();
        return switch (binary.operator()) {
            case LESS -> fact(binary, left + " < " + right, true);
            case GREATER_OR_EQUAL -> fact(binary, left + " < " + right, false);
            case GREATER -> fact(binary, right + " < " + left, true);
            case LESS_OR_EQUAL -> fact(binary, right + " < " + left, false);
            case EQUAL -> fact(binary, left + " == " + right, true);
            case NOT_EQUAL -> fact(binary, left + " == " + right, false);
            default -> test(binary);
        };
    }

    private Formula fact(Expression.Binary binary, String fact, boolean so) {
        return new Formula.Test(text.of(binary), fact, so, mayFail(binary), bounds(binary));
    }

    private List<Formula> row(Expression row, BinaryOperator operator) {
        return WrittenExpressions.row(row, operator).stream().map(this::of).toList();
    }

    private Formula is(Expression.PortRead read, boolean equal, Expression value) {
        Optional<Value> constant =
                value instanceof Expression.Constant c ? Optional.of(c.value()) : Optional.empty();
        return is(read, equal, value, constant);
    }

    private Formula is(
            Expression.PortRead read, boolean equal, Expression value, Optional<Value> constant) {
        if (constant.isPresent() && constant.get() instanceof Value.BooleanValue truth) {
            Expression not =
                    new Expression.Unary(UnaryOperator.NOT, read, read.type(), read.span());
            Value yes = new Value.BooleanValue(true);
            Formula.Is is =
                    new Formula.Is(
                            read.port(), true, Optional.of(yes), text.of(read), text.of(not));
            return truth.value() == equal ? is : is.negation();
        }
        Text same = text.equal(read, value);
        Text other = text.notEqual(read, value);
        if (value.contains(Expression.PortRead.class::isInstance) || mayFail(value)) {
            // Two silent ports have equal codes: this does not say that there is a message.
            return Formula.Test.of(equal ? same : other, mayFail(value));
        }
        return new Formula.Is(
                read.port(), equal, constant, equal ? same : other, equal ? other : same);
    }

    /** What a comparison of a number with a constant says. */
    private static Optional<Formula.Bounds> bounds(Expression.Binary binary) {
        Optional<String> number = number(binary.left());
        if (number.isEmpty()
                || !(binary.right() instanceof Expression.Constant constant)
                || !(constant.value() instanceof Value.IntegerValue integer)) {
            return Optional.empty();
        }
        long value = integer.value();
        boolean below = value > Long.MIN_VALUE;
        boolean above = value < Long.MAX_VALUE;
        return switch (binary.operator()) {
            case EQUAL -> between(number, value, value);
            case LESS_OR_EQUAL -> between(number, Long.MIN_VALUE, value);
            case GREATER_OR_EQUAL -> between(number, value, Long.MAX_VALUE);
            case LESS -> below ? between(number, Long.MIN_VALUE, value - 1) : Optional.empty();
            case GREATER -> above ? between(number, value + 1, Long.MAX_VALUE) : Optional.empty();
            default -> Optional.empty();
        };
    }

    private static Optional<Formula.Bounds> between(Optional<String> number, long low, long high) {
        return number.map(name -> new Formula.Bounds(name, low, high));
    }

    /** A variable goes by its name, as {@link RuntimeChecks} knows it, a message by its port. */
    private static Optional<String> number(Expression e) {
        if (e instanceof Expression.VariableRead read) {
            return Optional.of(read.variable().name());
        }
        return e instanceof Expression.PortRead read
                ? Optional.of("message on " + read.port().name())
                : Optional.empty();
    }
}

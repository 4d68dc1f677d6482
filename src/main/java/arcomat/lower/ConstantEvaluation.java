package arcomat.lower;

import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Value;

/** The values of expressions that read nothing: messages and arguments of stream tests. */
final class ConstantEvaluation implements Expression.Cases<Value> {
    private static final ConstantEvaluation INSTANCE = new ConstantEvaluation();

    private ConstantEvaluation() {}

    /**
     * @throws IllegalStateException if the expression does read something
     */
    static Value value(Expression expression) {
        return expression.match(INSTANCE);
    }

    @Override
    public Value constant(Expression.Constant constant) {
        return constant.value();
    }

    @Override
    public Value portRead(Expression.PortRead read) {
        throw notConstant(read);
    }

    @Override
    public Value variableRead(Expression.VariableRead read) {
        throw notConstant(read);
    }

    @Override
    public Value parameterRead(Expression.ParameterRead read) {
        throw notConstant(read);
    }

    @Override
    public Value attributeRead(Expression.AttributeRead read) {
        throw notConstant(read);
    }

    @Override
    public Value portMatches(Expression.PortMatches matches) {
        throw notConstant(matches);
    }

    @Override
    public Value judged(Expression.Judged judged) {
        throw notConstant(judged);
    }

    private static IllegalStateException notConstant(Expression expression) {
        return new IllegalStateException("not constant at " + expression.span());
    }

    @Override
    public Value cast(Expression.Cast cast) {
        return Conversion.convert(value(cast.operand()), cast.type());
    }

    @Override
    public Value conditional(Expression.Conditional conditional) {
        return value(
                isTrue(conditional.condition()) ? conditional.then() : conditional.otherwise());
    }

    @Override
    public Value isIn(Expression.IsIn membership) {
        Value element = value(membership.element());
        return truth(membership.set().stream().anyMatch(e -> equal(value(e), element)));
    }

    private static boolean isTrue(Expression expression) {
        return ((Value.BooleanValue) value(expression)).value();
    }

    private static Value truth(boolean value) {
        return new Value.BooleanValue(value);
    }

    @Override
    public Value unary(Expression.Unary unary) {
        Value operand = value(unary.operand());
        return switch (unary.operator()) {
            case NOT -> truth(!((Value.BooleanValue) operand).value());
            case NEGATE ->
                    operand instanceof Value.RealValue real
                            ? new Value.RealValue(-real.value())
                            : whole(-number(operand), unary.type());
            case COMPLEMENT -> whole(~number(operand), unary.type());
        };
    }

    @Override
    public Value binary(Expression.Binary binary) {
        return switch (binary.operator()) {
            case AND -> truth(isTrue(binary.left()) && isTrue(binary.right()));
            case OR -> truth(isTrue(binary.left()) || isTrue(binary.right()));
            case IMPLIES -> truth(!isTrue(binary.left()) || isTrue(binary.right()));
            case EQUIVALENT -> truth(isTrue(binary.left()) == isTrue(binary.right()));
            case EQUAL -> truth(equal(value(binary.left()), value(binary.right())));
            case NOT_EQUAL -> truth(!equal(value(binary.left()), value(binary.right())));
            case LESS, LESS_OR_EQUAL, GREATER, GREATER_OR_EQUAL -> truth(compare(binary));
            case MULTIPLY, DIVIDE, REMAINDER, PLUS, MINUS -> arithmetic(binary);
        };
    }

    /** Numbers as Java's {@code ==} has them: NaN equals nothing, and there is one zero. */
    private static boolean equal(Value left, Value right) {
        return left instanceof Value.RealValue
                ? Conversion.real(left) == Conversion.real(right)
                : left.equals(right);
    }

    /** Nothing is less than NaN, nor greater. */
    private static boolean compare(Expression.Binary binary) {
        Value left = value(binary.left());
        Value right = value(binary.right());
        if (!(left instanceof Value.RealValue)) {
            return holds(binary, Long.compare(number(left), number(right)));
        }
        double first = Conversion.real(left);
        double second = Conversion.real(right);
        boolean isOrdered = !Double.isNaN(first) && !Double.isNaN(second);
        // Double.compare would tell two zeros apart.
        return isOrdered && holds(binary, first < second ? -1 : first > second ? 1 : 0);
    }

    private static boolean holds(Expression.Binary binary, int order) {
        return switch (binary.operator()) {
            case LESS -> order < 0;
            case LESS_OR_EQUAL -> order <= 0;
            case GREATER -> order > 0;
            case GREATER_OR_EQUAL -> order >= 0;
            default -> throw new AssertionError(binary.operator());
        };
    }

    private static Value arithmetic(Expression.Binary binary) {
        Value left = value(binary.left());
        Value right = value(binary.right());
        if (left instanceof Value.StringValue text) {
            return new Value.StringValue(text.value() + ((Value.StringValue) right).value());
        }
        if (binary.type() instanceof Type.RealType) {
            double result = real(binary, Conversion.real(left), Conversion.real(right));
            return Conversion.convert(new Value.RealValue(result), binary.type());
        }
        return whole(whole(binary, number(left), number(right)), binary.type());
    }

    private static double real(Expression.Binary binary, double left, double right) {
        return switch (binary.operator()) {
            case MULTIPLY -> left * right;
            case DIVIDE -> left / right;
            case REMAINDER -> left % right;
            case PLUS -> left + right;
            case MINUS -> left - right;
            default -> throw new AssertionError(binary.operator());
        };
    }

    private static long whole(Expression.Binary binary, long left, long right) {
        return switch (binary.operator()) {
            case MULTIPLY -> left * right;
            case DIVIDE -> left / right;
            case REMAINDER -> left % right;
            case PLUS -> left + right;
            case MINUS -> left - right;
            default -> throw new AssertionError(binary.operator());
        };
    }

    private static long number(Value value) {
        return ((Value.IntegerValue) value).value();
    }

    private static Value whole(long value, Type type) {
        return new Value.IntegerValue(Conversion.wrap(value, ((Type.IntegerType) type).width()));
    }
}

package arcomat.symbols.names;

import arcomat.tree.Expression;
import arcomat.tree.Expression.UnaryOperator;

import java.util.Map;
import java.util.Optional;
import java.util.function.BinaryOperator;

/**
 * The truth of conditions about features: names of features, true and false, and what connects
 * them. All else has none.
 */
record FeatureCondition(Map<String, Boolean> choices)
        implements Expression.Cases<Optional<Boolean>> {

    @Override
    public Optional<Boolean> literal(Expression.Literal literal) {
        return literal.kind() == Expression.Literal.Kind.BOOLEAN
                ? Optional.of(LiteralValues.isTrue(literal))
                : Optional.empty();
    }

    @Override
    public Optional<Boolean> reference(Expression.Reference reference) {
        return Optional.ofNullable(choices.get(reference.name().text()));
    }

    @Override
    public Optional<Boolean> unary(Expression.Unary unary) {
        return unary.operator() == UnaryOperator.NOT
                ? unary.operand().match(this).map(truth -> !truth)
                : Optional.empty();
    }

    @Override
    public Optional<Boolean> binary(Expression.Binary binary) {
        return switch (binary.operator()) {
            case AND -> both(binary, (a, b) -> a && b);
            case OR -> both(binary, (a, b) -> a || b);
            case IMPLIES -> both(binary, (a, b) -> !a || b);
            case EQUIVALENT, EQUAL -> both(binary, (a, b) -> a.equals(b));
            case NOT_EQUAL -> both(binary, (a, b) -> !a.equals(b));
            case MULTIPLY, DIVIDE, REMAINDER, ADD, SUBTRACT -> Optional.empty();
            case LESS, LESS_OR_EQUAL, GREATER, GREATER_OR_EQUAL -> Optional.empty();
        };
    }

    private Optional<Boolean> both(Expression.Binary binary, BinaryOperator<Boolean> connective) {
        Optional<Boolean> left = binary.left().match(this);
        return left.flatMap(a -> binary.right().match(this).map(b -> connective.apply(a, b)));
    }

    @Override
    public Optional<Boolean> conditional(Expression.Conditional conditional) {
        Optional<Boolean> then = conditional.then().match(this);
        Optional<Boolean> otherwise = conditional.otherwise().match(this);
        return then.isEmpty() || otherwise.isEmpty()
                ? Optional.empty()
                : conditional.condition().match(this).flatMap(truth -> truth ? then : otherwise);
    }

    @Override
    public Optional<Boolean> membership(Expression.Membership membership) {
        return Optional.empty();
    }

    @Override
    public Optional<Boolean> absence(Expression.Absence absence) {
        return Optional.empty();
    }

    @Override
    public Optional<Boolean> cast(Expression.Cast cast) {
        return Optional.empty();
    }

    @Override
    public Optional<Boolean> instanceOf(Expression.InstanceOf instanceOf) {
        return Optional.empty();
    }

    @Override
    public Optional<Boolean> call(Expression.Call call) {
        return Optional.empty();
    }

    @Override
    public Optional<Boolean> javaExpression(Expression.JavaExpression javaExpression) {
        return Optional.empty();
    }

    @Override
    public Optional<Boolean> indexed(Expression.Indexed indexed) {
        return Optional.empty();
    }

    @Override
    public Optional<Boolean> quantified(Expression.Quantified quantified) {
        return Optional.empty();
    }

    @Override
    public Optional<Boolean> let(Expression.Let let) {
        return Optional.empty();
    }
}

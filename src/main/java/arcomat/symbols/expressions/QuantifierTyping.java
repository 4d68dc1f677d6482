package arcomat.symbols.expressions;

import static arcomat.symbols.expressions.Problems.quoted;

import arcomat.source.Span;
import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Expression;
import arcomat.tree.Name;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Quantifiers and {@code let}, which are short for what stands there when each name is replaced by
 * its values: a row of {@code &&} or of {@code ||}, and the body itself.
 */
final class QuantifierTyping {
    /** Bodies of one expression, all quantifiers in it together, and reads of long values. */
    static final int MOST = 1_000;

    private final ValueScope scope;
    private final Problems problems;
    private final Within typing;

    /** Types an expression where other names are known. */
    interface Within {
        TypedExpression type(Expression expression, ValueScope scope, TypeSymbol expected);
    }

    QuantifierTyping(ValueScope scope, Problems problems, Within typing) {
        this.scope = scope;
        this.problems = problems;
        this.typing = typing;
    }

    TypedExpression quantified(Expression.Quantified node) {
        boolean isFree = isFree(node.name());
        Optional<List<TypedExpression>> values =
                new Domains(scope, problems, this::here).values(node.domain());
        if (values.isEmpty() || !isFree) {
            return new TypedExpression.Erroneous(node, List.of());
        }
        Unfolded.Bound bound = bound(node.name(), node, node.domain().span());
        Set<Span> read = new HashSet<>();
        List<TypedExpression> bodies = new ArrayList<>();
        for (TypedExpression value : values.get()) {
            if (!problems.mayGrow(node, 1)) {
                return new TypedExpression.Erroneous(node, bodies);
            }
            bodies.add(
                    body(
                            node,
                            new BoundValue(node.name(), value, place -> read(bound, place, read))));
        }
        if (read.isEmpty() && !bodies.isEmpty() && isUnderstood(bodies.get(0))) {
            unused(node.name());
        }
        return bodies.isEmpty()
                ? new TypedExpression.Literal(node, node.all(), BuiltinType.BOOLEAN)
                : row(node, bodies);
    }

    private Unfolded.Bound bound(Name name, Expression giver, Span source) {
        Unfolded.Bound bound = new Unfolded.Bound(name, giver, source);
        problems.unfolding().names().add(bound);
        return bound;
    }

    private void read(Unfolded.Bound bound, Span place, Set<Span> read) {
        if (read.add(place)) {
            problems.unfolding().reads().add(new Unfolded.Read(bound, place));
        }
    }

    private TypedExpression here(Expression expression) {
        return typing.type(expression, scope, UnknownType.UNKNOWN);
    }

    private TypedExpression body(Expression.Quantified node, BoundValue value) {
        TypedExpression body =
                typing.type(node.body(), scope.with(List.of(value)), BuiltinType.BOOLEAN);
        if (!body.type().isErroneous() && !body.type().isBoolean()) {
            problems.report(
                    Kind.OPERAND_TYPE,
                    node.body(),
                    "what is said of each is Boolean, but %s has type %s"
                            .formatted(quoted(node.body()), body.type().text()));
        }
        return body;
    }

    /** Grouped by halves, so that many are no deep tree; from left to right all the same. */
    private static TypedExpression row(Expression.Quantified node, List<TypedExpression> bodies) {
        if (bodies.size() == 1) {
            return bodies.get(0);
        }
        int middle = (bodies.size() + 1) / 2;
        TypedExpression left = row(node, bodies.subList(0, middle));
        TypedExpression right = row(node, bodies.subList(middle, bodies.size()));
        Expression.BinaryOperator operator =
                node.all() ? Expression.BinaryOperator.AND : Expression.BinaryOperator.OR;
        return new TypedExpression.Binary(
                new Expression.Binary(node.span(), operator, left.node(), right.node()),
                left,
                right,
                BuiltinType.BOOLEAN,
                BuiltinType.BOOLEAN);
    }

    TypedExpression let(Expression.Let node, TypeSymbol expected) {
        boolean isFree = isFree(node.name());
        TypedExpression value = here(node.value());
        if (!isFree) {
            return new TypedExpression.Erroneous(node, List.of(value));
        }
        problems.unfolding().values().add(value);
        Unfolded.Bound named = bound(node.name(), node, node.value().span());
        int[] size = {0};
        value.walk(part -> size[0]++);
        boolean[] tooLong = {false};
        Set<Span> read = new HashSet<>();
        BoundValue bound =
                new BoundValue(
                        node.name(),
                        value,
                        place -> {
                            read(named, place, read);
                            tooLong[0] |= size[0] > 1 && !problems.mayGrow(node, size[0]);
                        });
        TypedExpression body = typing.type(node.body(), scope.with(List.of(bound)), expected);
        if (read.isEmpty() && isUnderstood(body)) {
            unused(node.name());
        }
        return read.isEmpty() || tooLong[0]
                ? new TypedExpression.Erroneous(node, List.of(value, body))
                : body;
    }

    private boolean isFree(Name name) {
        Optional<ValueSymbol> hidden = scope.value(name.text());
        hidden.ifPresent(
                other ->
                        problems.report(
                                new ExpressionProblem(
                                        Kind.BOUND_NAME,
                                        name.span(),
                                        "'%s' means something here already; give it another name"
                                                .formatted(name),
                                        Optional.empty())));
        return hidden.isEmpty();
    }

    /** Where it is not, a name may have been meant that nobody has seen. */
    private static boolean isUnderstood(TypedExpression body) {
        boolean[] understood = {true};
        body.walk(part -> understood[0] &= !(part instanceof TypedExpression.Erroneous));
        return understood[0];
    }

    private void unused(Name name) {
        problems.report(
                new ExpressionProblem(
                        Kind.BOUND_NAME,
                        name.span(),
                        "'%s' is not used; leave it out".formatted(name),
                        Optional.empty()));
    }
}

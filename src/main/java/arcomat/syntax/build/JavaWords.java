package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.tree.Block;
import arcomat.tree.Expression;
import arcomat.tree.Statement;
import arcomat.tree.TypeReference;
import arcomat.tree.Variable;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * What is Java in what parses as statements all the same: a call of a method, an object that is
 * made or asked for its class, a type that only Java has. The first of these.
 */
final class JavaWords implements Statement.Cases<Optional<Span>> {
    /** Of expressions. */
    private static final Set<Class<? extends Expression>> FORMS =
            Set.of(
                    Expression.Call.class,
                    Expression.JavaExpression.class,
                    Expression.InstanceOf.class);

    @Override
    public Optional<Span> sequence(Statement.Sequence sequence) {
        return first(sequence.statements().stream().map(each -> each.match(this)));
    }

    @Override
    public Optional<Span> assignment(Statement.Assignment assignment) {
        return in(assignment.message().value());
    }

    @Override
    public Optional<Span> choice(Statement.Choice choice) {
        return in(choice.condition())
                .or(() -> choice.then().match(this))
                .or(() -> choice.otherwise().flatMap(each -> each.match(this)));
    }

    @Override
    public Optional<Span> locals(Statement.Locals locals) {
        TypeReference type = locals.type();
        return !type.arguments().isEmpty() || type.dimensions() > 0
                ? Optional.of(type.span())
                : first(
                        locals.variables().stream()
                                .map(Variable::initial)
                                .flatMap(Optional::stream)
                                .map(JavaWords::in));
    }

    private static Optional<Span> in(Block.Value value) {
        if (value instanceof Block.Single single) {
            return in(single.expression());
        }
        List<Expression> messages =
                value instanceof Block.Sequence sequence ? sequence.messages() : List.of();
        return first(messages.stream().map(JavaWords::in));
    }

    private static Optional<Span> in(Expression expression) {
        return FORMS.contains(expression.getClass())
                ? Optional.of(expression.span())
                : first(expression.operands().stream().map(JavaWords::in));
    }

    private static Optional<Span> first(Stream<Optional<Span>> found) {
        return found.flatMap(Optional::stream).findFirst();
    }
}

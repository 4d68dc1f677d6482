package arcomat.syntax.build;

import arcomat.tree.Block;
import arcomat.tree.Expression;
import arcomat.tree.Statement;
import arcomat.tree.TypeReference;
import arcomat.tree.Variable;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Whether what parses as statements is Java all the same: it calls methods, makes objects, asks for
 * their classes, or has types that only Java has.
 */
final class JavaWords implements Statement.Cases<Boolean> {
    /** Of expressions. */
    private static final Set<Class<? extends Expression>> FORMS =
            Set.of(
                    Expression.Call.class,
                    Expression.JavaExpression.class,
                    Expression.InstanceOf.class);

    @Override
    public Boolean sequence(Statement.Sequence sequence) {
        return sequence.statements().stream().anyMatch(each -> each.match(this));
    }

    @Override
    public Boolean assignment(Statement.Assignment assignment) {
        return isIn(assignment.message().value());
    }

    @Override
    public Boolean choice(Statement.Choice choice) {
        return isIn(choice.condition())
                || choice.then().match(this)
                || choice.otherwise().map(each -> each.match(this)).orElse(false);
    }

    @Override
    public Boolean locals(Statement.Locals locals) {
        TypeReference type = locals.type();
        return !type.arguments().isEmpty()
                || type.dimensions() > 0
                || locals.variables().stream()
                        .map(Variable::initial)
                        .flatMap(Optional::stream)
                        .anyMatch(JavaWords::isIn);
    }

    private static boolean isIn(Block.Value value) {
        if (value instanceof Block.Single single) {
            return isIn(single.expression());
        }
        List<Expression> messages =
                value instanceof Block.Sequence sequence ? sequence.messages() : List.of();
        return messages.stream().anyMatch(JavaWords::isIn);
    }

    private static boolean isIn(Expression expression) {
        return FORMS.contains(expression.getClass())
                || expression.operands().stream().anyMatch(JavaWords::isIn);
    }
}

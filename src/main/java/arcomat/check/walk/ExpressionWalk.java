package arcomat.check.walk;

import arcomat.check.law.Context;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.tree.Expression;
import arcomat.tree.QualifiedName;
import arcomat.tree.TypeArgument;
import arcomat.tree.TypeReference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The part of the walk that goes through expressions and types, and collects their names. */
final class ExpressionWalk {
    private final Listeners listeners;
    private List<QualifiedName> names = new ArrayList<>();

    ExpressionWalk(Listeners listeners) {
        this.listeners = listeners;
    }

    /** The names since the last call. */
    List<QualifiedName> takeNames() {
        List<QualifiedName> taken = names;
        names = new ArrayList<>();
        return taken;
    }

    void name(QualifiedName name) {
        names.add(name);
    }

    void variable(VariableSymbol variable, Context context) {
        listeners.onVariable.ask((check, found) -> check.check(variable, context, found));
        optional(variable.initial(), context);
    }

    void optional(Optional<Typed> expression, Context context) {
        if (expression.isPresent()) {
            one(expression.get(), context);
        }
    }

    void all(List<Typed> expressions, Context context) {
        for (Typed expression : expressions) {
            one(expression, context);
        }
    }

    /** Takes the names of an expression that no law is about. */
    void mentioned(Typed expression, Context context) {
        parts(expression.expression().node(), context);
    }

    private void one(Typed expression, Context context) {
        listeners.onExpression.ask((check, found) -> check.check(expression, context, found));
        parts(expression.expression().node(), context);
    }

    /** A call without a target makes an object of a class in stream tests: {@code Cup(5)}. */
    private void parts(Expression expression, Context context) {
        if (expression instanceof Expression.Reference reference) {
            name(reference.name());
        } else if (expression instanceof Expression.Cast cast) {
            type(cast.type(), context);
        } else if (expression instanceof Expression.Call call && call.target().isEmpty()) {
            name(new QualifiedName(call.name().span(), List.of(call.name())));
        }
        expression.operands().forEach(operand -> parts(operand, context));
    }

    void type(TypeReference type, Context context) {
        listeners.onType.ask((check, found) -> check.check(type, context, found));
        componentType(type, context);
    }

    /** The type of a part or of an ancestor: of message types it has only its arguments. */
    void componentType(TypeReference type, Context context) {
        name(type.name());
        typeArguments(type.arguments(), context);
    }

    void typeArguments(List<TypeArgument> arguments, Context context) {
        for (TypeArgument argument : arguments) {
            if (argument instanceof TypeArgument.Given given) {
                type(given.type(), context);
            } else if (argument instanceof TypeArgument.Wildcard wildcard
                    && wildcard.bound().isPresent()) {
                type(wildcard.bound().get(), context);
            }
        }
    }
}

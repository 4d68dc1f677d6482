package arcomat.check.walk;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.walk.Listeners.Listener;
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
        for (Listener<Check.OnVariable> each : listeners.onVariable) {
            each.check().check(variable, context, each.findings());
        }
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
        for (Listener<Check.OnExpression> each : listeners.onExpression) {
            each.check().check(expression, context, each.findings());
        }
        parts(expression.expression().node(), context);
    }

    private void parts(Expression expression, Context context) {
        if (expression instanceof Expression.Reference reference) {
            name(reference.name());
        } else if (expression instanceof Expression.Binary binary) {
            parts(binary.left(), context);
            parts(binary.right(), context);
        } else if (expression instanceof Expression.Unary unary) {
            parts(unary.operand(), context);
        } else if (expression instanceof Expression.Absence absence) {
            parts(absence.operand(), context);
        } else if (expression instanceof Expression.Conditional conditional) {
            parts(conditional.condition(), context);
            parts(conditional.then(), context);
            parts(conditional.otherwise(), context);
        } else if (expression instanceof Expression.Membership membership) {
            parts(membership.element(), context);
            parts(membership.set(), context);
        } else if (expression instanceof Expression.Cast cast) {
            type(cast.type(), context);
            parts(cast.operand(), context);
        } else if (expression instanceof Expression.InstanceOf test) {
            parts(test.operand(), context);
        } else if (expression instanceof Expression.Call call) {
            call(call, context);
        }
    }

    private void parts(List<Expression> expressions, Context context) {
        for (Expression expression : expressions) {
            parts(expression, context);
        }
    }

    /** A call without a target makes an object of a class in stream tests: {@code Cup(5)}. */
    private void call(Expression.Call call, Context context) {
        if (call.target().isPresent()) {
            parts(call.target().get(), context);
        } else {
            name(new QualifiedName(call.name().span(), List.of(call.name())));
        }
        parts(call.arguments(), context);
    }

    void type(TypeReference type, Context context) {
        for (Listener<Check.OnType> each : listeners.onType) {
            each.check().check(type, context, each.findings());
        }
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

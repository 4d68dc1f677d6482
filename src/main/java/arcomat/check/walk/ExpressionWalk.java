package arcomat.check.walk;

import arcomat.check.law.Check;
import arcomat.check.law.Check.Context;
import arcomat.check.walk.Listeners.Listener;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;
import arcomat.tree.QualifiedName;
import arcomat.tree.TypeReference;
import arcomat.tree.TypeReference.TypeArgument;

import java.util.ArrayList;
import java.util.List;

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
        variable.initial().ifPresent(initial -> value(initial, variable.type(), context));
    }

    void all(List<Typed> expressions, Context context) {
        for (Typed expression : expressions) {
            one(expression, context);
        }
    }

    /** A value where something of a type is declared. */
    void value(Typed value, TypeSymbol type, Context context) {
        for (Listener<Check.OnValue> each : listeners.onValue) {
            each.check().check(value, type, context, each.findings());
        }
        one(value, context);
    }

    void values(List<Typed> values, TypeSymbol type, Context context) {
        for (Typed value : values) {
            value(value, type, context);
        }
    }

    /** Arguments, of which some may be for no parameter. */
    void arguments(List<GivenArgument> arguments, Context context) {
        for (GivenArgument argument : arguments) {
            if (argument.parameter().isPresent()) {
                value(argument.value(), argument.parameter().get().type(), context);
            } else {
                one(argument.value(), context);
            }
        }
    }

    /** Takes the names of an expression that no law is about. */
    void mentioned(Typed expression, Context context) {
        parts(expression.expression().node(), context);
    }

    void one(Typed expression, Context context) {
        for (Listener<Check.OnExpression> each : listeners.onExpression) {
            each.check().check(expression, context, each.findings());
        }
        parts(expression.expression().node(), context);
    }

    private void parts(Expression expression, Context context) {
        if (expression instanceof Expression.Leaf leaf) {
            leaf(leaf);
            return;
        }
        types(expression, context);
        domain(expression);
        for (Expression operand : expression.operands()) {
            parts(operand, context);
        }
    }

    /** A call without a target makes an object of a class in stream tests: {@code Cup(5)}. */
    private void types(Expression expression, Context context) {
        if (expression instanceof Expression.Call call && call.target().isEmpty()) {
            name(new QualifiedName(call.name().span(), List.of(call.name())));
        } else if (expression instanceof Expression.Cast cast) {
            type(cast.type(), context);
        }
    }

    private void domain(Expression expression) {
        if (expression instanceof Expression.Quantified quantified) {
            quantified.domain().named().ifPresent(named -> name(named.name()));
        }
    }

    private void leaf(Expression.Leaf leaf) {
        if (leaf instanceof Expression.Reference reference) {
            name(reference.name());
        }
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

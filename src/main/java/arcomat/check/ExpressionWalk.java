package arcomat.check;

import arcomat.check.Listeners.Listener;
import arcomat.tree.Block;
import arcomat.tree.Expression;
import arcomat.tree.TestSuite;
import arcomat.tree.TypeArgument;
import arcomat.tree.TypeReference;
import arcomat.tree.Variable;

import java.util.List;
import java.util.Optional;

/** The part of the walk that goes through expressions, values and types. */
final class ExpressionWalk {
    private final Listeners listeners;

    ExpressionWalk(Listeners listeners) {
        this.listeners = listeners;
    }

    void variable(Variable variable, TypeReference type, Context context) {
        for (Listener<Check.OnVariable> each : listeners.onVariable) {
            each.check().check(variable, type, context, each.findings());
        }
        optional(variable.initial(), context);
    }

    void value(Block.Value value, Context context) {
        if (value instanceof Block.Single single) {
            one(single.expression(), context);
        } else if (value instanceof Block.Sequence sequence) {
            all(sequence.messages(), context);
        } else if (value instanceof Block.Alternatives alternatives) {
            for (Block.Value each : alternatives.values()) {
                value(each, context);
            }
        }
    }

    void stream(List<TestSuite.StreamElement> elements, Context context) {
        for (TestSuite.StreamElement element : elements) {
            if (element instanceof TestSuite.Message message) {
                one(message.expression(), context);
            } else if (element instanceof TestSuite.Repeat repeat) {
                stream(repeat.elements(), context);
            }
        }
    }

    void optional(Optional<Expression> expression, Context context) {
        if (expression.isPresent()) {
            one(expression.get(), context);
        }
    }

    void all(List<Expression> expressions, Context context) {
        for (Expression expression : expressions) {
            one(expression, context);
        }
    }

    void one(Expression expression, Context context) {
        for (Listener<Check.OnExpression> each : listeners.onExpression) {
            each.check().check(expression, context, each.findings());
        }
        if (expression instanceof Expression.Binary binary) {
            one(binary.left(), context);
            one(binary.right(), context);
        } else if (expression instanceof Expression.Unary unary) {
            one(unary.operand(), context);
        } else if (expression instanceof Expression.Absence absence) {
            one(absence.operand(), context);
        } else if (expression instanceof Expression.Conditional conditional) {
            one(conditional.condition(), context);
            one(conditional.then(), context);
            one(conditional.otherwise(), context);
        } else if (expression instanceof Expression.Membership membership) {
            one(membership.element(), context);
            all(membership.set(), context);
        } else if (expression instanceof Expression.Cast cast) {
            type(cast.type(), context);
            one(cast.operand(), context);
        } else if (expression instanceof Expression.InstanceOf test) {
            one(test.operand(), context);
            type(test.type(), context);
        } else if (expression instanceof Expression.Call call) {
            optional(call.target(), context);
            all(call.arguments(), context);
        }
    }

    void type(TypeReference type, Context context) {
        for (Listener<Check.OnType> each : listeners.onType) {
            each.check().check(type, context, each.findings());
        }
        typeArguments(type.arguments(), context);
        if (type.range().isPresent()) {
            one(type.range().get().low(), context);
            one(type.range().get().high(), context);
        }
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

package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.source.Span;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.symbols.expressions.VariableSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Typed expressions of the text as expressions of the model. */
final class ExpressionLowering {
    private final Environment environment;

    ExpressionLowering(Environment environment) {
        this.environment = environment;
    }

    /** The expression, converted to the type of the place it stands in. */
    Expression lower(Typed typed, Type target) {
        return Conversion.to(target, lower(typed.expression()));
    }

    Expression lower(TypedExpression expression) {
        if (expression instanceof TypedExpression.Literal literal) {
            return literal(literal);
        }
        if (expression instanceof TypedExpression.Constant constant) {
            Type.EnumType type = TypeLowering.enumeration(constant.type());
            return new Expression.Constant(
                    new Value.EnumValue(type, constant.ordinal()), type, span(expression));
        }
        if (expression instanceof TypedExpression.PortRead read) {
            return new Expression.PortRead(
                    known(environment.ports(), read.port().name()), span(expression));
        }
        if (expression instanceof TypedExpression.VariableRead read) {
            return new Expression.VariableRead(variable(read.variable()), span(expression));
        }
        if (expression instanceof TypedExpression.ParameterRead read) {
            return parameter(read);
        }
        if (expression instanceof TypedExpression.AttributeRead read) {
            return new Expression.AttributeRead(
                    lower(read.object()),
                    read.index(),
                    environment.type(read.type()),
                    span(expression));
        }
        if (expression instanceof TypedExpression.Absence absence) {
            return absence(absence);
        }
        return composed(expression);
    }

    private Expression composed(TypedExpression expression) {
        if (expression instanceof TypedExpression.Unary unary) {
            return unary(unary);
        }
        if (expression instanceof TypedExpression.Binary binary) {
            return binary(binary);
        }
        if (expression instanceof TypedExpression.Conditional conditional) {
            return conditional(conditional);
        }
        if (expression instanceof TypedExpression.Membership membership) {
            return membership(membership);
        }
        if (expression instanceof TypedExpression.Cast cast) {
            Expression operand = lower(cast.operand());
            Expression converted = Conversion.to(environment.type(cast.type()), operand);
            return converted instanceof Expression.Cast made
                    ? new Expression.Cast(made.operand(), made.type(), span(expression))
                    : converted;
        }
        if (expression instanceof TypedExpression.NewObject object) {
            return newObject(object);
        }
        throw new IllegalStateException("erroneous expression at " + span(expression));
    }

    private static Span span(TypedExpression expression) {
        return expression.node().span();
    }

    private static <T> T known(Map<String, T> map, String name) {
        T value = map.get(name);
        if (value == null) {
            throw new IllegalStateException("unknown name: " + name);
        }
        return value;
    }

    Variable variable(VariableSymbol symbol) {
        return switch (symbol.kind()) {
            case AUTOMATON -> known(environment.variables(), symbol.name());
            case COMPONENT -> known(environment.constants(), symbol.name());
        };
    }

    private Expression parameter(TypedExpression.ParameterRead read) {
        String name = read.parameter().name();
        Expression argument = environment.arguments().get(name);
        return argument != null
                ? argument
                : new Expression.ParameterRead(known(environment.parameters(), name), span(read));
    }

    private Expression literal(TypedExpression.Literal literal) {
        return new Expression.Constant(
                value(literal.value()), environment.type(literal.type()), span(literal));
    }

    private static Value value(Object value) {
        if (value instanceof Boolean truth) {
            return new Value.BooleanValue(truth);
        }
        if (value instanceof Long number) {
            return new Value.IntegerValue(number);
        }
        if (value instanceof Double number) {
            return new Value.RealValue(number);
        }
        if (value instanceof Character character) {
            return new Value.CharacterValue(character);
        }
        if (value instanceof String text) {
            return new Value.StringValue(text);
        }
        throw new AssertionError(value);
    }

    private Expression absence(TypedExpression.Absence absence) {
        Automaton.Pattern pattern =
                absence.node().present() ? new Automaton.Present() : new Automaton.Absent();
        return new Expression.PortMatches(
                known(environment.ports(), absence.port().name()), pattern, span(absence));
    }

    private Expression unary(TypedExpression.Unary unary) {
        Type type = environment.type(unary.type());
        Expression operand = Conversion.to(type, lower(unary.operand()));
        return switch (unary.node().operator()) {
            case PLUS -> operand;
            case NOT ->
                    new Expression.Unary(Expression.UnaryOperator.NOT, operand, type, span(unary));
            case COMPLEMENT ->
                    new Expression.Unary(
                            Expression.UnaryOperator.COMPLEMENT, operand, type, span(unary));
            case MINUS ->
                    operand instanceof Expression.Constant constant
                            ? negated(constant, type, span(unary))
                            : new Expression.Unary(
                                    Expression.UnaryOperator.NEGATE, operand, type, span(unary));
        };
    }

    /** A minus before a number is part of the number. */
    private static Expression negated(Expression.Constant constant, Type type, Span span) {
        Value value =
                constant.value() instanceof Value.RealValue real
                        ? new Value.RealValue(-real.value())
                        : new Value.IntegerValue(
                                Conversion.wrap(
                                        -((Value.IntegerValue) constant.value()).value(),
                                        ((Type.IntegerType) type).width()));
        return new Expression.Constant(value, type, span);
    }

    private Expression binary(TypedExpression.Binary binary) {
        Type operands = environment.type(binary.operandType());
        return new Expression.Binary(
                Operators.binary(binary.node().operator()),
                Conversion.to(operands, lower(binary.left())),
                Conversion.to(operands, lower(binary.right())),
                environment.type(binary.type()),
                span(binary));
    }

    private Expression conditional(TypedExpression.Conditional conditional) {
        Type type = environment.type(conditional.type());
        return new Expression.Conditional(
                lower(conditional.condition()),
                Conversion.to(type, lower(conditional.then())),
                Conversion.to(type, lower(conditional.otherwise())),
                type,
                span(conditional));
    }

    private Expression membership(TypedExpression.Membership membership) {
        Type operands = environment.type(membership.operandType());
        List<Expression> set = new ArrayList<>();
        for (TypedExpression member : membership.set()) {
            set.add(Conversion.to(operands, lower(member)));
        }
        return new Expression.IsIn(
                Conversion.to(operands, lower(membership.element())), set, span(membership));
    }

    private Expression newObject(TypedExpression.NewObject object) {
        Type.ClassType type = TypeLowering.object(object.type());
        List<Value> attributes = new ArrayList<>();
        for (int i = 0; i < object.arguments().size(); i++) {
            Expression argument =
                    Conversion.to(
                            type.attributes().get(i).type(), lower(object.arguments().get(i)));
            attributes.add(ConstantEvaluation.value(argument));
        }
        return new Expression.Constant(new Value.ObjectValue(type, attributes), type, span(object));
    }
}

package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Expression.UnaryOperator;
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
record ExpressionLowering(Environment environment) implements TypedExpression.Cases<Expression> {

    /** The expression, converted to the type of the place it stands in. */
    Expression lower(Typed typed, Type target) {
        return lower(typed.expression(), target);
    }

    Expression lower(TypedExpression expression) {
        return expression.match(this);
    }

    private Expression lower(TypedExpression expression, Type target) {
        return Conversion.to(target, lower(expression));
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

    /** A variable of the component that is no constant of it is one of its automaton. */
    Variable variable(VariableSymbol symbol) {
        Variable constant =
                symbol.kind() == VariableSymbol.Kind.COMPONENT
                        ? environment.constants().get(symbol.name())
                        : null;
        return constant == null ? known(environment.variables(), symbol.name()) : constant;
    }

    @Override
    public Expression literal(TypedExpression.Literal literal) {
        return new Expression.Constant(
                WrittenMessages.value(literal.value()),
                environment.type(literal.type()),
                span(literal));
    }

    @Override
    public Expression constant(TypedExpression.Constant constant) {
        Type.EnumType type = TypeLowering.enumeration(constant.type());
        return new Expression.Constant(
                new Value.EnumValue(type, constant.ordinal()), type, span(constant));
    }

    @Override
    public Expression portRead(TypedExpression.PortRead read) {
        return new Expression.PortRead(known(environment.ports(), read.port().name()), span(read));
    }

    @Override
    public Expression variableRead(TypedExpression.VariableRead read) {
        Variable variable = variable(read.variable());
        return read.variable().kind() == VariableSymbol.Kind.SUITE
                ? variable.initial()
                : new Expression.VariableRead(variable, span(read));
    }

    @Override
    public Expression parameterRead(TypedExpression.ParameterRead read) {
        Expression settled = environment.settled().get(read.parameter());
        if (settled != null) {
            return settled;
        }
        String name = read.parameter().name();
        Expression argument = environment.arguments().get(name);
        return argument != null
                ? argument
                : new Expression.ParameterRead(known(environment.parameters(), name), span(read));
    }

    @Override
    public Expression attributeRead(TypedExpression.AttributeRead read) {
        return new Expression.AttributeRead(
                lower(read.object()), read.index(), environment.type(read.type()), span(read));
    }

    @Override
    public Expression absence(TypedExpression.Absence absence) {
        Automaton.Pattern pattern =
                absence.node().present() ? new Automaton.Present() : new Automaton.Absent();
        return new Expression.PortMatches(
                known(environment.ports(), absence.port().name()), pattern, span(absence));
    }

    @Override
    public Expression unary(TypedExpression.Unary unary) {
        Type type = environment.type(unary.type());
        Expression operand = lower(unary.operand(), type);
        return switch (unary.node().operator()) {
            case PLUS -> operand;
            case NOT -> new Expression.Unary(UnaryOperator.NOT, operand, type, span(unary));
            case COMPLEMENT ->
                    new Expression.Unary(UnaryOperator.COMPLEMENT, operand, type, span(unary));
            case MINUS ->
                    operand instanceof Expression.Constant constant
                            ? negated(constant, type, span(unary))
                            : new Expression.Unary(
                                    UnaryOperator.NEGATE, operand, type, span(unary));
        };
    }

    /** A minus before a number is part of the number. */
    private static Expression negated(Expression.Constant constant, Type type, Span span) {
        Expression negation = new Expression.Unary(UnaryOperator.NEGATE, constant, type, span);
        return new Expression.Constant(ConstantEvaluation.value(negation), type, span);
    }

    @Override
    public Expression binary(TypedExpression.Binary binary) {
        Type operands = environment.type(binary.operandType());
        return new Expression.Binary(
                operator(binary.node().operator()),
                lower(binary.left(), operands),
                lower(binary.right(), operands),
                environment.type(binary.type()),
                span(binary));
    }

    private static BinaryOperator operator(arcomat.tree.Expression.BinaryOperator operator) {
        return switch (operator) {
            case MULTIPLY -> BinaryOperator.MULTIPLY;
            case DIVIDE -> BinaryOperator.DIVIDE;
            case REMAINDER -> BinaryOperator.REMAINDER;
            case ADD -> BinaryOperator.PLUS;
            case SUBTRACT -> BinaryOperator.MINUS;
            case LESS -> BinaryOperator.LESS;
            case LESS_OR_EQUAL -> BinaryOperator.LESS_OR_EQUAL;
            case GREATER -> BinaryOperator.GREATER;
            case GREATER_OR_EQUAL -> BinaryOperator.GREATER_OR_EQUAL;
            case EQUAL -> BinaryOperator.EQUAL;
            case NOT_EQUAL -> BinaryOperator.NOT_EQUAL;
            case AND -> BinaryOperator.AND;
            case OR -> BinaryOperator.OR;
            case IMPLIES -> BinaryOperator.IMPLIES;
            case EQUIVALENT -> BinaryOperator.EQUIVALENT;
        };
    }

    @Override
    public Expression conditional(TypedExpression.Conditional conditional) {
        Type type = environment.type(conditional.type());
        return new Expression.Conditional(
                lower(conditional.condition()),
                lower(conditional.then(), type),
                lower(conditional.otherwise(), type),
                type,
                span(conditional));
    }

    @Override
    public Expression membership(TypedExpression.Membership membership) {
        Type operands = environment.type(membership.operandType());
        return new Expression.IsIn(
                lower(membership.element(), operands),
                membership.set().stream().map(member -> lower(member, operands)).toList(),
                span(membership));
    }

    @Override
    public Expression cast(TypedExpression.Cast cast) {
        Expression converted = lower(cast.operand(), environment.type(cast.type()));
        return converted instanceof Expression.Cast made
                ? new Expression.Cast(made.operand(), made.type(), span(cast))
                : converted;
    }

    @Override
    public Expression newObject(TypedExpression.NewObject object) {
        Type.ClassType type = TypeLowering.constructed(object.type());
        List<Value> attributes = new ArrayList<>();
        for (int i = 0; i < object.arguments().size(); i++) {
            Type attribute = type.attributes().get(i).type();
            attributes.add(ConstantEvaluation.value(lower(object.arguments().get(i), attribute)));
        }
        return new Expression.Constant(new Value.ObjectValue(type, attributes), type, span(object));
    }

    @Override
    public Expression erroneous(TypedExpression.Erroneous erroneous) {
        throw new IllegalStateException("erroneous expression at " + span(erroneous));
    }
}

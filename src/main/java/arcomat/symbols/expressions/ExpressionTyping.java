package arcomat.symbols.expressions;

import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Expression;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;

/** Gives names and types to expressions. */
public final class ExpressionTyping {
    private final ValueScope scope;
    private final boolean objects;
    private final ReferenceTyping references;
    private final List<ExpressionProblem> problems = new ArrayList<>();

    private ExpressionTyping(ValueScope scope, boolean objects) {
        this.scope = scope;
        this.objects = objects;
        this.references = new ReferenceTyping(scope, this::report);
    }

    /**
     * Types an expression.
     *
     * @param expected the type of the place it stands in: a bare name that is no value is looked up
     *     among the constants of an expected enumeration. Unknown where nothing is expected.
     *     Whether the result fits is for the caller to ask.
     */
    public static Typed type(Expression expression, ValueScope scope, TypeSymbol expected) {
        return run(expression, scope, expected, false);
    }

    /** Types a message of a stream test, where objects may be written as {@code Cup(5)}. */
    /** Types expressions at one place. */
    public static BiFunction<Expression, TypeSymbol, Typed> at(ValueScope scope) {
        return (expression, expected) -> type(expression, scope, expected);
    }

    public static Typed message(Expression expression, ValueScope scope, TypeSymbol expected) {
        return run(expression, scope, expected, true);
    }

    private static Typed run(
            Expression expression, ValueScope scope, TypeSymbol expected, boolean objects) {
        ExpressionTyping typing = new ExpressionTyping(scope, objects);
        TypedExpression typed = typing.type(expression, expected);
        return new Typed(typed, typing.problems);
    }

    private TypedExpression type(Expression expression, TypeSymbol expected) {
        return (objects ? RealNames.type(expression, expected) : Optional.<TypedExpression>empty())
                .orElseGet(() -> typeAny(expression, expected));
    }

    private TypedExpression typeAny(Expression expression, TypeSymbol expected) {
        if (expression instanceof Expression.Literal literal) {
            return literal(literal, false);
        }
        if (expression instanceof Expression.Reference reference) {
            return references.type(reference, expected);
        }
        if (expression instanceof Expression.Unary unary) {
            return unary(unary);
        }
        if (expression instanceof Expression.Binary binary) {
            return binary(binary);
        }
        if (expression instanceof Expression.Conditional conditional) {
            return conditional(conditional, expected);
        }
        if (expression instanceof Expression.Membership membership) {
            return membership(membership);
        }
        if (expression instanceof Expression.Absence absence) {
            return absence(absence);
        }
        if (expression instanceof Expression.Cast cast) {
            return cast(cast);
        }
        if (expression instanceof Expression.Call call) {
            return call(call);
        }
        if (expression instanceof Expression.InstanceOf
                || expression instanceof Expression.JavaExpression) {
            return unsupported(expression);
        }
        throw new AssertionError(expression);
    }

    private TypedExpression unsupported(Expression expression) {
        return erroneous(
                expression,
                ExpressionProblem.Kind.UNSUPPORTED_EXPRESSION,
                "'"
                        + Texts.shortened(expression.span().text())
                        + "' is Java, not an expression of models; use literals, names and"
                        + " operators");
    }

    private TypedExpression literal(Expression.Literal literal, boolean negated) {
        return LiteralTyping.type(literal, negated, this::report);
    }

    private TypedExpression unary(Expression.Unary unary) {
        boolean minus = unary.operator() == Expression.UnaryOperator.MINUS;
        TypedExpression operand =
                minus && unary.operand() instanceof Expression.Literal literal
                        ? LiteralTyping.magnitude(literal, this::report)
                        : type(unary.operand(), UnknownType.UNKNOWN);
        return new TypedExpression.Unary(unary, operand, resultOf(unary, operand.type()));
    }

    private TypeSymbol resultOf(Expression.Unary unary, TypeSymbol operand) {
        boolean applies =
                switch (unary.operator()) {
                    case NOT -> operand.isBoolean();
                    case MINUS, PLUS -> operand.isNumeric();
                    case COMPLEMENT -> operand.isIntegral();
                };
        if (operand.isErroneous()) {
            return unary.operator() == Expression.UnaryOperator.NOT
                    ? BuiltinType.BOOLEAN
                    : UnknownType.UNKNOWN;
        }
        if (!applies) {
            String wanted =
                    switch (unary.operator()) {
                        case NOT -> "a Boolean";
                        case MINUS, PLUS -> "a number";
                        case COMPLEMENT -> "a whole number";
                    };
            report(
                    ExpressionProblem.Kind.OPERAND_TYPE,
                    unary,
                    "'"
                            + unary.operator().symbol()
                            + "' needs "
                            + wanted
                            + ", but '"
                            + Texts.shortened(unary.operand().span().text())
                            + "' has type "
                            + operand.text());
            return UnknownType.UNKNOWN;
        }
        return unary.operator() == Expression.UnaryOperator.NOT
                ? BuiltinType.BOOLEAN
                : TypeRules.promoted(operand, operand);
    }

    private TypedExpression binary(Expression.Binary binary) {
        List<TypedExpression> operands = together(List.of(binary.left(), binary.right()));
        TypedExpression left = operands.get(0);
        TypedExpression right = operands.get(1);
        OperatorTyping.Result result = OperatorTyping.type(binary, left, right, this::report);
        return new TypedExpression.Binary(binary, left, right, result.operands(), result.result());
    }

    /**
     * Types expressions that meet in a comparison or a choice: a bare constant gets its enumeration
     * from the others.
     */
    private List<TypedExpression> together(List<Expression> expressions) {
        return together(expressions, UnknownType.UNKNOWN);
    }

    private List<TypedExpression> together(List<Expression> expressions, TypeSymbol expected) {
        TypedExpression[] typed = new TypedExpression[expressions.size()];
        TypeSymbol common = expected;
        for (int i = 0; i < typed.length; i++) {
            if (!references.isBareConstant(expressions.get(i))) {
                typed[i] = type(expressions.get(i), expected);
                common = common.isErroneous() ? typed[i].type() : common;
            }
        }
        boolean pointless = common.isErroneous() && hasErroneous(typed);
        for (int i = 0; i < typed.length; i++) {
            if (typed[i] == null) {
                typed[i] =
                        pointless
                                ? new TypedExpression.Erroneous(expressions.get(i), List.of())
                                : type(expressions.get(i), common);
            }
        }
        return List.of(typed);
    }

    /** Whether a partner is in error, so that nothing can be said about a bare name beside it. */
    private static boolean hasErroneous(TypedExpression[] typed) {
        for (TypedExpression expression : typed) {
            if (expression != null && expression.type().isErroneous()) {
                return true;
            }
        }
        return false;
    }

    private TypedExpression conditional(Expression.Conditional node, TypeSymbol expected) {
        TypedExpression condition = type(node.condition(), BuiltinType.BOOLEAN);
        if (!condition.type().isErroneous() && !condition.type().isBoolean()) {
            report(
                    ExpressionProblem.Kind.OPERAND_TYPE,
                    node.condition(),
                    "a condition is Boolean, but '"
                            + Texts.shortened(node.condition().span().text())
                            + "' has type "
                            + condition.type().text());
        }
        List<TypedExpression> branches = together(List.of(node.then(), node.otherwise()), expected);
        TypedExpression then = branches.get(0);
        TypedExpression otherwise = branches.get(1);
        TypeSymbol type = commonType(node, then.type(), otherwise.type());
        return new TypedExpression.Conditional(node, condition, then, otherwise, type);
    }

    private TypeSymbol commonType(Expression node, TypeSymbol a, TypeSymbol b) {
        if (a.isErroneous() || b.isErroneous()) {
            return UnknownType.UNKNOWN;
        }
        if (a.equals(b)) {
            return a;
        }
        if (a.base().equals(b.base())) {
            return a.base();
        }
        if (a.isNumeric() && b.isNumeric()) {
            return TypeRules.promoted(a, b);
        }
        report(
                ExpressionProblem.Kind.OPERAND_TYPE,
                node,
                "both branches of a choice have one type, but these have "
                        + a.text()
                        + " and "
                        + b.text());
        return UnknownType.UNKNOWN;
    }

    private TypedExpression membership(Expression.Membership node) {
        List<Expression> all = new ArrayList<>();
        all.add(node.element());
        all.addAll(node.set());
        List<TypedExpression> typed = together(all);
        TypedExpression element = typed.get(0);
        TypeSymbol operands = element.type();
        for (TypedExpression member : typed.subList(1, typed.size())) {
            if (!TypeRules.areComparable(element.type(), member.type())) {
                report(
                        ExpressionProblem.Kind.OPERAND_TYPE,
                        member.node(),
                        "'"
                                + Texts.shortened(member.node().span().text())
                                + "' has type "
                                + member.type().text()
                                + " and never equals a value of type "
                                + element.type().text());
            } else if (operands.isNumeric() && member.type().isNumeric()) {
                operands = TypeRules.promoted(operands, member.type());
            }
        }
        return new TypedExpression.Membership(
                node, element, typed.subList(1, typed.size()), operands);
    }

    private TypedExpression absence(Expression.Absence node) {
        TypedExpression operand = type(node.operand(), UnknownType.UNKNOWN);
        if (operand instanceof TypedExpression.PortRead read) {
            return new TypedExpression.Absence(node, read.port());
        }
        if (!operand.type().isErroneous()) {
            report(
                    ExpressionProblem.Kind.ABSENCE_OF_NO_PORT,
                    node,
                    "only a port can be without a message; '"
                            + Texts.shortened(node.operand().span().text())
                            + "' is no port");
        }
        return new TypedExpression.Erroneous(node, List.of(operand));
    }

    private TypedExpression cast(Expression.Cast node) {
        TypedExpression operand = type(node.operand(), UnknownType.UNKNOWN);
        TypeSymbol target = CastTyping.target(node, operand.type(), scope, this::report);
        return new TypedExpression.Cast(node, operand, target);
    }

    private TypedExpression call(Expression.Call call) {
        if (objects) {
            var named = references.constructed(call);
            if (named.isPresent()) {
                return newObject(call, named.get());
            }
            if (call.target().isEmpty()) {
                return erroneous(
                        call,
                        ExpressionProblem.Kind.UNKNOWN_NAME,
                        "there is no class '"
                                + call.name()
                                + "' here; import it or correct the name");
            }
        }
        return erroneous(
                call,
                ExpressionProblem.Kind.UNSUPPORTED_CALL,
                call.name().text().equals("equals")
                        ? "models call no methods; compare with '==' instead of 'equals'"
                        : "models call no methods ('"
                                + call.name()
                                + "'); compute the value in a <<platform>> component and send it"
                                + " over a port");
    }

    private TypedExpression newObject(Expression.Call call, ClassSymbol type) {
        List<ClassSymbol.AttributeSymbol> attributes = type.attributes();
        List<TypedExpression> arguments = new ArrayList<>();
        for (Expression argument : call.arguments()) {
            int i = arguments.size();
            arguments.add(
                    type(
                            argument,
                            i < attributes.size()
                                    ? attributes.get(i).type()
                                    : UnknownType.UNKNOWN));
        }
        return ObjectTyping.type(call, type, arguments, this::report);
    }

    private TypedExpression erroneous(
            Expression expression, ExpressionProblem.Kind kind, String message) {
        report(kind, expression, message);
        return new TypedExpression.Erroneous(expression, List.of());
    }

    private void report(ExpressionProblem.Kind kind, Expression at, String message) {
        report(kind, at, message, Optional.empty());
    }

    private void report(
            ExpressionProblem.Kind kind,
            Expression at,
            String message,
            Optional<String> suggestion) {
        problems.add(new ExpressionProblem(kind, at.span(), message, suggestion));
    }
}

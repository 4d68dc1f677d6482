package arcomat.symbols.expressions;

import static arcomat.symbols.expressions.Problems.quoted;

import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.JavaType;
import arcomat.symbols.names.OpaqueSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.symbols.names.UnsupportedType;
import arcomat.tree.Expression;

import java.util.List;
import java.util.Optional;

/** Types each form of expression, at a place where some type is expected. */
final class FormTyping implements Expression.Cases<TypedExpression> {
    private static final String LOOKED_INTO =
            "nobody looks into a message of type %s, so '%s' cannot be called; compute the value in"
                    + " a <<platform>> component and send it over a port";

    private final ValueScope scope;
    private final Problems problems;
    private final ReferenceTyping references;
    private final Optional<ObjectTyping> objects;
    private final TypeSymbol expected;

    /**
     * @param objects whether they may be written out, and floating point numbers without a literal
     *     be named
     */
    FormTyping(ValueScope scope, boolean objects, Problems problems, TypeSymbol expected) {
        this.scope = scope;
        this.problems = problems;
        this.references = new ReferenceTyping(scope, problems);
        this.objects =
                objects
                        ? Optional.of(new ObjectTyping(scope.unitScope(), problems, this::type))
                        : Optional.empty();
        this.expected = expected;
    }

    private FormTyping(FormTyping other, TypeSymbol expected) {
        this.scope = other.scope;
        this.problems = other.problems;
        this.references = other.references;
        this.objects = other.objects;
        this.expected = expected;
    }

    private TypedExpression within(Expression expression, ValueScope inner, TypeSymbol type) {
        return new FormTyping(inner, objects.isPresent(), problems, type).type(expression, type);
    }

    private QuantifierTyping quantifiers() {
        return new QuantifierTyping(scope, problems, this::within);
    }

    TypedExpression type(Expression expression, TypeSymbol type) {
        Optional<TypedExpression> real =
                objects.isPresent() ? ObjectTyping.namedReal(expression, type) : Optional.empty();
        if (real.isPresent()) {
            return real.get();
        }
        return expression.match(type == expected ? this : new FormTyping(this, type));
    }

    private TypedExpression type(Expression expression) {
        return type(expression, UnknownType.UNKNOWN);
    }

    @Override
    public TypedExpression literal(Expression.Literal literal) {
        return LiteralTyping.type(literal, false, problems);
    }

    @Override
    public TypedExpression reference(Expression.Reference reference) {
        return references.type(reference, expected);
    }

    /** Behind a minus, one more than the greatest number is fine. */
    @Override
    public TypedExpression unary(Expression.Unary unary) {
        boolean minus = unary.operator() == Expression.UnaryOperator.MINUS;
        TypedExpression operand =
                minus && unary.operand() instanceof Expression.Literal literal
                        ? LiteralTyping.type(literal, true, problems)
                        : type(unary.operand());
        return new TypedExpression.Unary(
                unary, operand, OperatorTyping.type(unary, operand.type(), problems));
    }

    @Override
    public TypedExpression binary(Expression.Binary binary) {
        List<TypedExpression> operands =
                together(List.of(binary.left(), binary.right()), UnknownType.UNKNOWN);
        TypedExpression left = operands.get(0);
        TypedExpression right = operands.get(1);
        OperatorTyping.Result result = OperatorTyping.type(binary, left, right, problems);
        return new TypedExpression.Binary(binary, left, right, result.operands(), result.result());
    }

    /**
     * Types expressions that meet in a comparison or a choice: a bare constant gets its enumeration
     * from the others.
     */
    private List<TypedExpression> together(List<Expression> expressions, TypeSymbol type) {
        TypedExpression[] typed = new TypedExpression[expressions.size()];
        TypeSymbol common = type;
        for (int i = 0; i < typed.length; i++) {
            if (!references.isBareConstant(expressions.get(i))) {
                typed[i] = type(expressions.get(i), type);
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

    @Override
    public TypedExpression conditional(Expression.Conditional node) {
        TypedExpression condition = type(node.condition(), BuiltinType.BOOLEAN);
        if (!condition.type().isErroneous() && !condition.type().isBoolean()) {
            problems.report(
                    Kind.OPERAND_TYPE,
                    node.condition(),
                    "a condition is Boolean, but %s has type %s"
                            .formatted(quoted(node.condition()), condition.type().text()));
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
        if (a.base().equals(b.base())) {
            return a.equals(b) ? a : a.base();
        }
        if (a.isNumeric() && b.isNumeric()) {
            return TypeRules.promoted(a, b);
        }
        problems.report(
                Kind.OPERAND_TYPE,
                node,
                "both branches of a choice have one type, but these have %s and %s"
                        .formatted(a.text(), b.text()));
        return UnknownType.UNKNOWN;
    }

    @Override
    public TypedExpression membership(Expression.Membership node) {
        List<TypedExpression> typed = together(node.operands(), UnknownType.UNKNOWN);
        TypedExpression element = typed.get(0);
        List<TypedExpression> set = typed.subList(1, typed.size());
        TypeSymbol operands = element.type();
        for (TypedExpression member : set) {
            if (!TypeRules.areComparable(element.type(), member.type())) {
                problems.report(
                        Kind.OPERAND_TYPE,
                        member.node(),
                        "%s has type %s and never equals a value of type %s"
                                .formatted(
                                        quoted(member.node()),
                                        member.type().text(),
                                        element.type().text()));
            } else if (operands.isNumeric() && member.type().isNumeric()) {
                operands = TypeRules.promoted(operands, member.type());
            }
        }
        return new TypedExpression.Membership(node, element, set, operands);
    }

    @Override
    public TypedExpression absence(Expression.Absence node) {
        TypedExpression operand = type(node.operand());
        if (operand instanceof TypedExpression.PortRead read) {
            return new TypedExpression.Absence(node, read.port());
        }
        if (!operand.type().isErroneous()) {
            problems.report(
                    Kind.ABSENCE_OF_NO_PORT,
                    node,
                    "only a port can be without a message; %s is no port"
                            .formatted(quoted(node.operand())));
        }
        return new TypedExpression.Erroneous(node, List.of(operand));
    }

    @Override
    public TypedExpression cast(Expression.Cast node) {
        TypedExpression operand = type(node.operand());
        return new TypedExpression.Cast(node, operand, target(node, operand.type()));
    }

    /** Casts are between number types, and to the type that a value has anyway. */
    private TypeSymbol target(Expression.Cast node, TypeSymbol from) {
        Resolution<TypeSymbol> resolution = scope.type(node.type());
        TypeSymbol target = resolution.found().orElse(UnknownType.UNKNOWN);
        if (resolution.isUnknown()) {
            problems.report(
                    Kind.UNKNOWN_NAME, node, "there is no type '" + node.type().name() + "'");
        } else if (resolution.isAmbiguous()) {
            problems.report(
                    Kind.AMBIGUOUS_NAME,
                    node,
                    "several types could be meant by '%s'; qualify it fully"
                            .formatted(node.type().name()));
        } else if (target instanceof UnsupportedType unsupported) {
            problems.report(
                    Kind.UNSUPPORTED_EXPRESSION,
                    node,
                    "no cast to " + unsupported.text() + "; " + unsupported.advice());
        } else if (!converts(from, target)) {
            problems.report(
                    Kind.CAST,
                    node,
                    "a value of type %s cannot be cast to %s; casts convert between number types"
                            .formatted(from.text(), target.text()));
            return UnknownType.UNKNOWN;
        }
        return target;
    }

    private static boolean converts(TypeSymbol from, TypeSymbol target) {
        boolean numbers = target instanceof BuiltinType && target.isNumeric() && from.isNumeric();
        return numbers || from.isErroneous() || target.isErroneous() || target.equals(from.base());
    }

    @Override
    public TypedExpression call(Expression.Call call) {
        return objects.flatMap(o -> o.type(call, expected)).orElseGet(() -> unsupported(call));
    }

    private TypedExpression unsupported(Expression.Call call) {
        String why =
                call.name().text().equals("equals")
                        ? "models call no methods; compare with '==' instead of 'equals'"
                        : "models call no methods ('"
                                + call.name()
                                + "'); compute the value in a <<platform>> component and send it"
                                + " over a port";
        Optional<String> closed =
                call.target().map(this::silently).filter(FormTyping::isClosed).map(t -> t.text());
        return problems.erroneous(
                Kind.UNSUPPORTED_CALL,
                call,
                closed.filter(type -> !call.name().text().equals("equals"))
                        .map(type -> LOOKED_INTO.formatted(type, call.name()))
                        .orElse(why));
    }

    /** The type of what is reported somewhere else, or not at all. */
    private TypeSymbol silently(Expression expression) {
        return new FormTyping(scope, objects.isPresent(), new Problems(), UnknownType.UNKNOWN)
                .type(expression)
                .type();
    }

    /** Whether nobody looks into its messages. */
    private static boolean isClosed(TypeSymbol type) {
        return type instanceof JavaType || type instanceof OpaqueSymbol;
    }

    @Override
    public TypedExpression instanceOf(Expression.InstanceOf node) {
        return java(node);
    }

    @Override
    public TypedExpression javaExpression(Expression.JavaExpression node) {
        return java(node);
    }

    @Override
    public TypedExpression indexed(Expression.Indexed node) {
        return new ElementTyping(scope, problems, references, this::type)
                .type(node, expected)
                .orElseGet(() -> java(node));
    }

    @Override
    public TypedExpression quantified(Expression.Quantified node) {
        return quantifiers().quantified(node);
    }

    @Override
    public TypedExpression let(Expression.Let node) {
        return quantifiers().let(node, expected);
    }

    private TypedExpression java(Expression node) {
        if (node instanceof Expression.JavaExpression java && java.text().matches("(?s)new\\b.*")) {
            return problems.erroneous(
                    Kind.UNSUPPORTED_EXPRESSION,
                    node,
                    quoted(node)
                            + " makes an object, and models make none; have a <<platform>>"
                            + " component make it and send it over a port");
        }
        return problems.erroneous(
                Kind.UNSUPPORTED_EXPRESSION,
                node,
                quoted(node)
                        + " is Java, not an expression of models; use literals, names and"
                        + " operators");
    }
}

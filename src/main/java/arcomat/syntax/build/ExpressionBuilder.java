package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.Argument;
import arcomat.tree.Expression;
import arcomat.tree.Expression.Absence;
import arcomat.tree.Expression.Binary;
import arcomat.tree.Expression.BinaryOperator;
import arcomat.tree.Expression.Call;
import arcomat.tree.Expression.Cast;
import arcomat.tree.Expression.Conditional;
import arcomat.tree.Expression.Domain;
import arcomat.tree.Expression.Indexed;
import arcomat.tree.Expression.InstanceOf;
import arcomat.tree.Expression.JavaExpression;
import arcomat.tree.Expression.Let;
import arcomat.tree.Expression.Literal;
import arcomat.tree.Expression.Member;
import arcomat.tree.Expression.Membership;
import arcomat.tree.Expression.Quantified;
import arcomat.tree.Expression.Reference;
import arcomat.tree.Expression.Unary;
import arcomat.tree.Expression.UnaryOperator;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;
import arcomat.tree.TypeReference;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/** Expressions. Parentheses leave no node. */
final class ExpressionBuilder extends TreeBuilder<Expression> {
    /** Longer ones would be deep trees. */
    private static final int LONG_ROW = 16;

    /** By type of token, since most texts of tokens are never asked for. */
    private static final BinaryOperator[] BINARY =
            byToken(BinaryOperator.values(), BinaryOperator::symbol, BinaryOperator[]::new);

    private static final UnaryOperator[] UNARY =
            byToken(UnaryOperator.values(), UnaryOperator::symbol, UnaryOperator[]::new);

    private static <O> O[] byToken(
            O[] operators, Function<O, String> symbol, IntFunction<O[]> array) {
        O[] all = array.apply(ArcomatLexer.VOCABULARY.getMaxTokenType() + 1);
        for (O operator : operators) {
            all[typeOf(symbol.apply(operator))] = operator;
        }
        return all;
    }

    private static int typeOf(String symbol) {
        return IntStream.rangeClosed(1, ArcomatLexer.VOCABULARY.getMaxTokenType())
                .filter(
                        type ->
                                ("'" + symbol + "'")
                                        .equals(ArcomatLexer.VOCABULARY.getLiteralName(type)))
                .findFirst()
                .orElseThrow();
    }

    ExpressionBuilder(Phrases phrases) {
        super(phrases);
    }

    List<Expression> arguments(ArcomatParser.ArgumentsContext context) {
        return context == null ? List.of() : buildAll(context.expression());
    }

    List<Argument> given(ArcomatParser.@Nullable ComponentArgumentsContext context) {
        return context == null ? List.of() : each(context.componentArgument(), this::given);
    }

    private Argument given(ArcomatParser.ComponentArgumentContext context) {
        return new Argument(
                span(context), phrases.optionalName(context.name()), build(context.expression()));
    }

    @Override
    public Expression visitOperandExpression(ArcomatParser.OperandExpressionContext context) {
        return operand(context.primary(), context.suffix());
    }

    @Override
    public Expression visitPlainOperand(ArcomatParser.PlainOperandContext context) {
        return operand(context.primary(), context.suffix());
    }

    private Expression operand(
            ArcomatParser.PrimaryContext primary, List<ArcomatParser.SuffixContext> suffixes) {
        Expression result = visitPrimary(primary);
        // "(a).b" is no qualified name, though its parentheses leave no node.
        boolean isName = primary.name() != null;
        for (ArcomatParser.SuffixContext suffix : suffixes) {
            result = join(primary.start, result, isName, suffix);
        }
        return result;
    }

    /** A name or a call behind a dot; everything else is Java. */
    private Expression join(
            Token first, Expression target, boolean isName, ArcomatParser.SuffixContext suffix) {
        Span span = span(first, suffix.stop);
        if (suffix instanceof ArcomatParser.AccessSuffixContext access) {
            Name name = phrases.name(access.name());
            if (access.arguments() != null) {
                return new Call(span, Optional.of(target), name, arguments(access.arguments()));
            }
            if (isName && target instanceof Reference reference) {
                List<Name> parts = new ArrayList<>(reference.name().parts());
                parts.add(name);
                return new Reference(span, new QualifiedName(span, List.copyOf(parts)));
            }
            if (target instanceof Indexed indexed) {
                return indexed(span, indexed.steps(), step(name));
            }
        }
        if (suffix instanceof ArcomatParser.IndexSuffixContext index && isName) {
            return element(span, target, index).orElseGet(() -> java(first, suffix.stop));
        }
        return java(first, suffix.stop);
    }

    private Expression java(Token first, Token last) {
        return new JavaExpression(span(first, last), phrases.text(first, last));
    }

    /** The last name of a path, with its number. */
    private Optional<Expression> element(
            Span span, Expression target, ArcomatParser.IndexSuffixContext suffix) {
        List<Indexed.Step> before = steps(target);
        if (before.isEmpty() || before.get(before.size() - 1).index().isPresent()) {
            return Optional.empty();
        }
        Name array = before.get(before.size() - 1).name();
        Span place = array.span().to(span(suffix.start, suffix.stop));
        return Optional.of(
                indexed(
                        span,
                        before.subList(0, before.size() - 1),
                        new Indexed.Step(place, array, Optional.of(build(suffix.expression())))));
    }

    private static List<Indexed.Step> steps(Expression target) {
        if (target instanceof Indexed indexed) {
            return indexed.steps();
        }
        return target instanceof Reference reference
                ? reference.name().parts().stream().map(ExpressionBuilder::step).toList()
                : List.of();
    }

    private static Indexed.Step step(Name name) {
        return new Indexed.Step(name.span(), name, Optional.empty());
    }

    private static Indexed indexed(Span span, List<Indexed.Step> before, Indexed.Step last) {
        List<Indexed.Step> steps = new ArrayList<>(before);
        steps.add(last);
        return new Indexed(span, steps);
    }

    @Override
    public Expression visitPrimary(ArcomatParser.PrimaryContext context) {
        if (context.name() != null) {
            return named(context);
        }
        if (context.literal() != null) {
            return visitLiteral(context.literal());
        }
        return context.expression() == null ? creation(context) : build(context.expression());
    }

    private Expression named(ArcomatParser.PrimaryContext context) {
        Name name = phrases.name(context.name());
        return context.arguments() == null
                ? new Reference(name.span(), new QualifiedName(name.span(), List.of(name)))
                : new Call(span(context), Optional.empty(), name, arguments(context.arguments()));
    }

    private Expression creation(ArcomatParser.PrimaryContext context) {
        return java(context.start, context.stop);
    }

    @Override
    public Expression visitLiteral(ArcomatParser.LiteralContext context) {
        Span span = span(context);
        return new Literal(span, kind(context.kind), phrases.knownText(context));
    }

    private static Literal.Kind kind(Token token) {
        return switch (token.getType()) {
            case ArcomatLexer.INT -> Literal.Kind.INT;
            case ArcomatLexer.LONG -> Literal.Kind.LONG;
            case ArcomatLexer.FLOAT -> Literal.Kind.FLOAT;
            case ArcomatLexer.DOUBLE -> Literal.Kind.DOUBLE;
            case ArcomatLexer.CHAR -> Literal.Kind.CHAR;
            case ArcomatLexer.STRING -> Literal.Kind.STRING;
            default -> token.getText().equals("null") ? Literal.Kind.NULL : Literal.Kind.BOOLEAN;
        };
    }

    @Override
    public Expression visitUnaryExpression(ArcomatParser.UnaryExpressionContext context) {
        return unary(context, context.operator, context.expression());
    }

    @Override
    public Expression visitUnaryOperand(ArcomatParser.UnaryOperandContext context) {
        return unary(context, context.operator, context.castOperand());
    }

    private Expression unary(ParserRuleContext context, Token operator, ParserRuleContext operand) {
        return new Unary(span(context), UNARY[operator.getType()], build(operand));
    }

    @Override
    public Expression visitPrimitiveCastExpression(
            ArcomatParser.PrimitiveCastExpressionContext context) {
        return cast(context, phrases.type(context.primitiveType()), context.expression());
    }

    @Override
    public Expression visitCastExpression(ArcomatParser.CastExpressionContext context) {
        return cast(context, phrases.type(context.objectType()), context.castOperand());
    }

    @Override
    public Expression visitPrimitiveCastOperand(ArcomatParser.PrimitiveCastOperandContext context) {
        return cast(context, phrases.type(context.primitiveType()), context.castOperand());
    }

    @Override
    public Expression visitTypeCastOperand(ArcomatParser.TypeCastOperandContext context) {
        return cast(context, phrases.type(context.objectType()), context.castOperand());
    }

    private Expression cast(
            ParserRuleContext context, TypeReference type, ParserRuleContext operand) {
        return new Cast(span(context), type, build(operand));
    }

    @Override
    public Expression visitBinaryExpression(ArcomatParser.BinaryExpressionContext context) {
        BinaryOperator operator = BINARY[context.operator.getType()];
        if (!Rows.goesOn(context)) {
            Expression left = build(context.left);
            return binary(span(context), operator, left, build(context.right));
        }
        List<ArcomatParser.ExpressionContext> row = Rows.operands(context);
        return row(operator, row, row.size() > LONG_ROW);
    }

    /**
     * Operands joined by one operator.
     *
     * @param shallow groups a long row by halves, which means the same: its operator evaluates from
     *     left to right, however operands are grouped
     */
    private Expression row(
            BinaryOperator operator, List<ArcomatParser.ExpressionContext> row, boolean shallow) {
        int last = row.size() - 1;
        if (last == 0) {
            return build(row.get(0));
        }
        int middle = shallow ? (row.size() + 1) / 2 : last;
        Expression left = row(operator, row.subList(0, middle), shallow);
        Expression right = row(operator, row.subList(middle, row.size()), shallow);
        return binary(span(row.get(0).getStart(), row.get(last).getStop()), operator, left, right);
    }

    /** {@code p == null} is how Java says that there is no message. */
    private static Expression binary(
            Span span, BinaryOperator operator, Expression left, Expression right) {
        boolean compares = operator == BinaryOperator.EQUAL || operator == BinaryOperator.NOT_EQUAL;
        if (compares && (isNull(left) || isNull(right))) {
            Expression port = isNull(right) ? left : right;
            return new Absence(span, port, operator == BinaryOperator.NOT_EQUAL);
        }
        return new Binary(span, operator, left, right);
    }

    static boolean isNull(Expression expression) {
        return expression instanceof Literal literal && literal.kind() == Literal.Kind.NULL;
    }

    @Override
    public Expression visitInstanceOfExpression(ArcomatParser.InstanceOfExpressionContext context) {
        return new InstanceOf(
                span(context), build(context.expression()), phrases.type(context.instanceType()));
    }

    @Override
    public Expression visitMembershipExpression(ArcomatParser.MembershipExpressionContext context) {
        List<ArcomatParser.ExpressionContext> all = context.expression();
        return new Membership(
                span(context), build(all.get(0)), buildAll(all.subList(1, all.size())));
    }

    @Override
    public Expression visitAbsenceExpression(ArcomatParser.AbsenceExpressionContext context) {
        boolean present = context.operator.getText().equals("!=");
        return new Absence(span(context), build(context.expression()), present);
    }

    @Override
    public Expression visitQuantifiedExpression(ArcomatParser.QuantifiedExpressionContext context) {
        return new Quantified(
                span(context),
                context.quantifier.getText().equals("forall"),
                phrases.name(context.name()),
                domain(context.domain()),
                build(context.expression()));
    }

    private Domain domain(ArcomatParser.DomainContext context) {
        if (context instanceof ArcomatParser.NamedDomainContext named) {
            return new Domain(span(context), Optional.of(phrases.type(named.type())), List.of());
        }
        var members = (ArcomatParser.MemberDomainContext) context;
        return new Domain(span(context), Optional.empty(), each(members.member(), this::member));
    }

    private Member member(ArcomatParser.MemberContext context) {
        return new Member(span(context), build(context.low), optional(context.high, this::build));
    }

    @Override
    public Expression visitLetExpression(ArcomatParser.LetExpressionContext context) {
        return new Let(
                span(context),
                phrases.name(context.name()),
                build(context.expression(0)),
                build(context.expression(1)));
    }

    @Override
    public Expression visitConditionalExpression(
            ArcomatParser.ConditionalExpressionContext context) {
        return conditional(context, context.expression());
    }

    @Override
    public Expression visitIfExpression(ArcomatParser.IfExpressionContext context) {
        return conditional(context, context.expression());
    }

    private Expression conditional(
            ParserRuleContext context, List<ArcomatParser.ExpressionContext> parts) {
        return new Conditional(
                span(context), build(parts.get(0)), build(parts.get(1)), build(parts.get(2)));
    }
}

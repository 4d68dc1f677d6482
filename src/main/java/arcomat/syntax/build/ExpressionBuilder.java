package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatParser.AbsenceExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.ArgumentsContext;
import arcomat.syntax.antlr.ArcomatParser.BinaryExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.CastExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.ConditionalExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.CreationPrimaryContext;
import arcomat.syntax.antlr.ArcomatParser.ExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.IfExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.InstanceOfExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.LiteralContext;
import arcomat.syntax.antlr.ArcomatParser.LiteralPrimaryContext;
import arcomat.syntax.antlr.ArcomatParser.MembershipExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.NamePrimaryContext;
import arcomat.syntax.antlr.ArcomatParser.OperandContext;
import arcomat.syntax.antlr.ArcomatParser.OperandExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.ParenthesesPrimaryContext;
import arcomat.syntax.antlr.ArcomatParser.PlainOperandContext;
import arcomat.syntax.antlr.ArcomatParser.PrimitiveCastExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.PrimitiveCastOperandContext;
import arcomat.syntax.antlr.ArcomatParser.TypeCastOperandContext;
import arcomat.syntax.antlr.ArcomatParser.UnaryExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.UnaryOperandContext;
import arcomat.tree.Expression;
import arcomat.tree.Expression.Absence;
import arcomat.tree.Expression.Binary;
import arcomat.tree.Expression.BinaryOperator;
import arcomat.tree.Expression.Cast;
import arcomat.tree.Expression.Conditional;
import arcomat.tree.Expression.InstanceOf;
import arcomat.tree.Expression.JavaExpression;
import arcomat.tree.Expression.Literal;
import arcomat.tree.Expression.Membership;
import arcomat.tree.Expression.Unary;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;

import java.util.List;

/** Expressions. Parentheses leave no node. */
final class ExpressionBuilder extends TreeBuilder<Expression> {
    /** Longer ones would be deep trees. */
    private static final int LONG_ROW = 16;

    final TypeBuilder types;
    private final OperandBuilder operands;

    ExpressionBuilder(SharedTexts texts, NameBuilder names, QualifiedNameBuilder qualifiedNames) {
        super(texts);
        this.types = new TypeBuilder(texts, qualifiedNames, this);
        this.operands = new OperandBuilder(names, this);
    }

    List<Expression> arguments(ArgumentsContext context) {
        return context == null ? List.of() : buildAll(context.expression());
    }

    @Override
    public Expression visitOperandExpression(OperandExpressionContext context) {
        return build(context.operand());
    }

    @Override
    public Expression visitPlainOperand(PlainOperandContext context) {
        return build(context.operand());
    }

    @Override
    public Expression visitOperand(OperandContext context) {
        return operands.operand(context);
    }

    @Override
    public Expression visitLiteralPrimary(LiteralPrimaryContext context) {
        return build(context.literal());
    }

    @Override
    public Expression visitLiteral(LiteralContext context) {
        Span span = span(context.kind);
        return new Literal(span, Literals.kindOf(context.kind), texts.text(span));
    }

    @Override
    public Expression visitNamePrimary(NamePrimaryContext context) {
        return operands.name(context);
    }

    @Override
    public Expression visitParenthesesPrimary(ParenthesesPrimaryContext context) {
        return build(context.expression());
    }

    @Override
    public Expression visitCreationPrimary(CreationPrimaryContext context) {
        Span span = span(context);
        return new JavaExpression(span, span.text());
    }

    @Override
    public Expression visitUnaryExpression(UnaryExpressionContext context) {
        return unary(context, context.operator, context.expression());
    }

    @Override
    public Expression visitUnaryOperand(UnaryOperandContext context) {
        return unary(context, context.operator, context.castOperand());
    }

    private Expression unary(ParserRuleContext context, Token operator, ParserRuleContext operand) {
        return new Unary(span(context), Operators.unary(operator), build(operand));
    }

    @Override
    public Expression visitPrimitiveCastExpression(PrimitiveCastExpressionContext context) {
        return cast(context, context.primitiveType(), context.expression());
    }

    @Override
    public Expression visitCastExpression(CastExpressionContext context) {
        return cast(context, context.objectType(), context.castOperand());
    }

    @Override
    public Expression visitPrimitiveCastOperand(PrimitiveCastOperandContext context) {
        return cast(context, context.primitiveType(), context.castOperand());
    }

    @Override
    public Expression visitTypeCastOperand(TypeCastOperandContext context) {
        return cast(context, context.objectType(), context.castOperand());
    }

    private Expression cast(
            ParserRuleContext context, ParserRuleContext type, ParserRuleContext operand) {
        return new Cast(span(context), types.build(type), build(operand));
    }

    @Override
    public Expression visitBinaryExpression(BinaryExpressionContext context) {
        List<ExpressionContext> row = Rows.operands(context);
        return row(Operators.binary(context.operator), row, row.size() > LONG_ROW);
    }

    /**
     * Operands joined by one operator.
     *
     * @param shallow groups a long row by halves, which means the same: its operator evaluates from
     *     left to right, however operands are grouped
     */
    private Expression row(BinaryOperator operator, List<ExpressionContext> row, boolean shallow) {
        int last = row.size() - 1;
        if (last == 0) {
            return build(row.get(0));
        }
        int middle = shallow ? (row.size() + 1) / 2 : last;
        Expression left = row(operator, row.subList(0, middle), shallow);
        Expression right = row(operator, row.subList(middle, row.size()), shallow);
        return new Binary(
                span(row.get(0).getStart(), row.get(last).getStop()), operator, left, right);
    }

    @Override
    public Expression visitInstanceOfExpression(InstanceOfExpressionContext context) {
        return new InstanceOf(
                span(context), build(context.expression()), types.build(context.instanceType()));
    }

    @Override
    public Expression visitMembershipExpression(MembershipExpressionContext context) {
        List<ExpressionContext> all = context.expression();
        return new Membership(
                span(context), build(all.get(0)), buildAll(all.subList(1, all.size())));
    }

    @Override
    public Expression visitAbsenceExpression(AbsenceExpressionContext context) {
        boolean present = context.operator.getText().equals("!=");
        return new Absence(span(context), build(context.expression()), present);
    }

    @Override
    public Expression visitConditionalExpression(ConditionalExpressionContext context) {
        return conditional(context, context.expression());
    }

    @Override
    public Expression visitIfExpression(IfExpressionContext context) {
        return conditional(context, context.expression());
    }

    private Expression conditional(ParserRuleContext context, List<ExpressionContext> parts) {
        return new Conditional(
                span(context), build(parts.get(0)), build(parts.get(1)), build(parts.get(2)));
    }
}

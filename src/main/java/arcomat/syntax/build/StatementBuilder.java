package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.Block;
import arcomat.tree.Expression;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;
import arcomat.tree.Statement;

import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Optional;

/** What is done one after the other. */
final class StatementBuilder extends TreeBuilder<Statement> {
    private final BlockBuilder.ValueBuilder values;

    StatementBuilder(Phrases phrases, BlockBuilder.ValueBuilder values) {
        super(phrases);
        this.values = values;
    }

    Statement.Sequence sequence(ArcomatParser.StatementsContext context) {
        return new Statement.Sequence(span(context), buildAll(context.statement()));
    }

    @Override
    public Statement visitNestedStatements(ArcomatParser.NestedStatementsContext context) {
        return sequence(context.statements());
    }

    /** A branch that does not parse is a gap, and nothing is done there. */
    @Override
    public Statement visitChoiceStatement(ArcomatParser.ChoiceStatementContext context) {
        return new Statement.Choice(
                span(context),
                phrases.expressions.build(context.expression()),
                branch(context, context.then)
                        .orElseGet(() -> new Statement.Sequence(span(context), List.of())),
                branch(context, context.otherwise));
    }

    private Optional<Statement> branch(
            ArcomatParser.ChoiceStatementContext choice,
            ArcomatParser.@Nullable StatementContext branch) {
        return branch != null && choice.statement().contains(branch)
                ? Optional.of(build(branch))
                : Optional.empty();
    }

    @Override
    public Statement visitMarkedLocals(ArcomatParser.MarkedLocalsContext context) {
        return new Statement.Locals(
                span(context), phrases.type(context.type()), phrases.variables(context.variable()));
    }

    @Override
    public Statement visitPlainLocals(ArcomatParser.PlainLocalsContext context) {
        return new Statement.Locals(
                span(context),
                phrases.type(context.plainType()),
                phrases.variables(context.variable()));
    }

    @Override
    public Statement visitAssignment(ArcomatParser.AssignmentContext context) {
        return assignment(context, phrases.place(context.place()), values.build(context.value()));
    }

    @Override
    public Statement visitChangeStatement(ArcomatParser.ChangeStatementContext context) {
        return change(
                context,
                context.place(),
                context.operator,
                phrases.expressions.build(context.expression()));
    }

    @Override
    public Statement visitStepStatement(ArcomatParser.StepStatementContext context) {
        Span one = span(context.operator, context.operator);
        return change(
                context,
                context.place(),
                context.operator,
                new Expression.Literal(one, Expression.Literal.Kind.INT, "1"));
    }

    private Statement change(
            ArcomatParser.StatementContext context,
            ArcomatParser.PlaceContext target,
            Token operator,
            Expression amount) {
        Name name = phrases.place(target);
        Expression before =
                new Expression.Reference(
                        name.span(), new QualifiedName(name.span(), List.of(name)));
        boolean up = operator.getText().charAt(0) == '+';
        Expression after =
                new Expression.Binary(
                        span(context),
                        up ? Expression.BinaryOperator.ADD : Expression.BinaryOperator.SUBTRACT,
                        before,
                        amount);
        return assignment(context, name, new Block.Single(span(context), after));
    }

    private Statement assignment(
            ArcomatParser.StatementContext context, Name name, Block.Value value) {
        return new Statement.Assignment(
                span(context), new Block.Message(span(context), Optional.of(name), value));
    }
}

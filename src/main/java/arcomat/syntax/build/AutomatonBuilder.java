package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Block;
import arcomat.tree.Statement;
import arcomat.tree.Variable;

import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Automata and their elements. */
final class AutomatonBuilder extends TreeBuilder<AutomatonElement> {
    private final BlockBuilder blocks;
    final StatementBuilder statements;

    AutomatonBuilder(Phrases phrases, BlockBuilder blocks) {
        super(phrases);
        this.blocks = blocks;
        this.statements = new StatementBuilder(phrases, blocks.values);
    }

    Automaton automaton(ArcomatParser.AutomatonContext context) {
        return new Automaton(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                phrases.optionalName(context.name()),
                buildAll(context.automatonElement()));
    }

    @Override
    public AutomatonElement visitDeclaration(ArcomatParser.DeclarationContext context) {
        return new AutomatonElement.Declaration(
                span(context),
                kind(context.kind),
                phrases.type(context.type()),
                phrases.variables(context.variable()));
    }

    @Override
    public AutomatonElement visitMarkedDeclaration(ArcomatParser.MarkedDeclarationContext context) {
        return new AutomatonElement.Declaration(
                span(context),
                AutomatonElement.Kind.VARIABLE,
                phrases.type(context.type()),
                phrases.variables(context.variable()));
    }

    @Override
    public AutomatonElement visitPlainDeclaration(ArcomatParser.PlainDeclarationContext context) {
        List<Variable> variables = new ArrayList<>();
        variables.addAll(phrases.variables(context.valuedVariable()));
        variables.addAll(phrases.variables(context.variable()));
        return new AutomatonElement.Declaration(
                span(context),
                AutomatonElement.Kind.VARIABLE,
                phrases.type(context.plainType()),
                List.copyOf(variables));
    }

    private static AutomatonElement.Kind kind(Token token) {
        return switch (token.getText()) {
            case "input" -> AutomatonElement.Kind.INPUT;
            case "output" -> AutomatonElement.Kind.OUTPUT;
            default -> AutomatonElement.Kind.VARIABLE;
        };
    }

    @Override
    public AutomatonElement visitStates(ArcomatParser.StatesContext context) {
        return new AutomatonElement.States(span(context), each(context.state(), this::state));
    }

    private AutomatonElement.State state(ArcomatParser.StateContext context) {
        return new AutomatonElement.State(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                phrases.name(context.name()),
                List.of());
    }

    @Override
    public AutomatonElement visitInitial(ArcomatParser.InitialContext context) {
        return new AutomatonElement.Initial(
                span(context),
                phrases.names(context.name()),
                List.of(),
                output(context.effect()),
                actions(context.effect()));
    }

    @Override
    public AutomatonElement visitInitialBehind(ArcomatParser.InitialBehindContext context) {
        return new AutomatonElement.Initial(
                span(context),
                phrases.names(context.name()),
                List.of(),
                output(context.effect()),
                actions(context.effect()));
    }

    @Override
    public AutomatonElement visitInitialStates(ArcomatParser.InitialStatesContext context) {
        List<AutomatonElement.State> declared = each(context.state(), this::state);
        return new AutomatonElement.Initial(
                span(context),
                declared.stream().map(AutomatonElement.State::name).toList(),
                declared,
                output(context.effect()),
                actions(context.effect()));
    }

    private Optional<Block> output(ArcomatParser.@Nullable EffectContext context) {
        return context == null ? Optional.empty() : optional(context.block(), blocks::block);
    }

    private Optional<Statement.Sequence> actions(ArcomatParser.@Nullable EffectContext context) {
        return context == null
                ? Optional.empty()
                : optional(context.statements(), statements::sequence);
    }

    @Override
    public AutomatonElement visitTransition(ArcomatParser.TransitionContext context) {
        return new AutomatonElement.Transition(
                span(context),
                phrases.name(context.source),
                phrases.optionalName(context.target),
                optional(context.guard(), this::guard),
                optional(context.input, blocks::block),
                output(context.effect()),
                actions(context.effect()),
                0,
                0);
    }

    private AutomatonElement.Guard guard(ArcomatParser.GuardContext context) {
        return new AutomatonElement.Guard(
                span(context),
                phrases.optionalName(context.name()),
                phrases.expressions.build(context.expression()));
    }
}

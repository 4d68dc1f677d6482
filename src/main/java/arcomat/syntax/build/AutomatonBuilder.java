package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser.AutomatonContext;
import arcomat.syntax.antlr.ArcomatParser.DeclarationContext;
import arcomat.syntax.antlr.ArcomatParser.GuardContext;
import arcomat.syntax.antlr.ArcomatParser.InitialContext;
import arcomat.syntax.antlr.ArcomatParser.MarkedDeclarationContext;
import arcomat.syntax.antlr.ArcomatParser.PlainDeclarationContext;
import arcomat.syntax.antlr.ArcomatParser.StateContext;
import arcomat.syntax.antlr.ArcomatParser.StatesContext;
import arcomat.syntax.antlr.ArcomatParser.TransitionContext;
import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;
import arcomat.tree.AutomatonElement.Declaration;
import arcomat.tree.AutomatonElement.Guard;
import arcomat.tree.AutomatonElement.Initial;
import arcomat.tree.AutomatonElement.Kind;
import arcomat.tree.AutomatonElement.State;
import arcomat.tree.AutomatonElement.States;
import arcomat.tree.AutomatonElement.Transition;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Automata and their elements. */
final class AutomatonBuilder extends TreeBuilder<AutomatonElement> {
    private final Phrases phrases;
    private final BlockBuilder blocks;

    AutomatonBuilder(Phrases phrases, BlockBuilder blocks) {
        super(phrases.texts);
        this.phrases = phrases;
        this.blocks = blocks;
    }

    Automaton automaton(AutomatonContext context) {
        return new Automaton(
                span(context),
                phrases.stereotypes.stereotypes(context.stereotypes()),
                phrases.names.buildOptional(context.name()),
                buildAll(context.automatonElement()));
    }

    @Override
    public AutomatonElement visitDeclaration(DeclarationContext context) {
        return new Declaration(
                span(context),
                kind(context.kind),
                phrases.types.build(context.type()),
                phrases.variables.buildAll(context.variable()));
    }

    @Override
    public AutomatonElement visitMarkedDeclaration(MarkedDeclarationContext context) {
        return new Declaration(
                span(context),
                Kind.VARIABLE,
                phrases.types.build(context.type()),
                phrases.variables.buildAll(context.variable()));
    }

    @Override
    public AutomatonElement visitPlainDeclaration(PlainDeclarationContext context) {
        List<ParserRuleContext> variables = new ArrayList<>(context.variable());
        variables.add(0, context.valuedVariable());
        return new Declaration(
                span(context),
                Kind.VARIABLE,
                phrases.types.build(context.plainType()),
                phrases.variables.buildAll(variables));
    }

    private static Kind kind(Token token) {
        return switch (token.getText()) {
            case "input" -> Kind.INPUT;
            case "output" -> Kind.OUTPUT;
            default -> Kind.VARIABLE;
        };
    }

    @Override
    public AutomatonElement visitStates(StatesContext context) {
        List<State> states = new ArrayList<>();
        for (StateContext state : context.state()) {
            states.add(state(state));
        }
        return new States(span(context), states);
    }

    private State state(StateContext context) {
        return new State(
                span(context),
                phrases.stereotypes.stereotypes(context.stereotypes()),
                phrases.names.build(context.name()));
    }

    @Override
    public AutomatonElement visitInitial(InitialContext context) {
        return new Initial(
                span(context),
                phrases.names.buildAll(context.name()),
                blocks.block(context.block()));
    }

    @Override
    public AutomatonElement visitTransition(TransitionContext context) {
        return new Transition(
                span(context),
                phrases.names.build(context.source),
                phrases.names.buildOptional(context.target),
                guard(context.guard()),
                blocks.block(context.input),
                blocks.block(context.output));
    }

    private Optional<Guard> guard(GuardContext context) {
        if (context == null) {
            return Optional.empty();
        }
        return Optional.of(
                new Guard(
                        span(context),
                        phrases.names.buildOptional(context.name()),
                        phrases.expressions.build(context.expression())));
    }
}

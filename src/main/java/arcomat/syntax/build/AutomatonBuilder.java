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
    AutomatonBuilder(Builders builders) {
        super(builders);
    }

    Automaton automaton(AutomatonContext context) {
        return new Automaton(
                span(context),
                builders.stereotypes.stereotypes(context.stereotypes()),
                builders.names.buildOptional(context.name()),
                buildAll(context.automatonElement()));
    }

    @Override
    public AutomatonElement visitDeclaration(DeclarationContext context) {
        return new Declaration(
                span(context),
                kind(context.kind),
                builders.types.build(context.type()),
                builders.variables.buildAll(context.variable()));
    }

    @Override
    public AutomatonElement visitMarkedDeclaration(MarkedDeclarationContext context) {
        return new Declaration(
                span(context),
                Kind.VARIABLE,
                builders.types.build(context.type()),
                builders.variables.buildAll(context.variable()));
    }

    @Override
    public AutomatonElement visitPlainDeclaration(PlainDeclarationContext context) {
        List<ParserRuleContext> variables = new ArrayList<>(context.variable());
        variables.add(0, context.valuedVariable());
        return new Declaration(
                span(context),
                Kind.VARIABLE,
                builders.types.build(context.plainType()),
                builders.variables.buildAll(variables));
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
                builders.stereotypes.stereotypes(context.stereotypes()),
                builders.names.build(context.name()));
    }

    @Override
    public AutomatonElement visitInitial(InitialContext context) {
        return new Initial(
                span(context),
                builders.names.buildAll(context.name()),
                builders.blocks.block(context.block()));
    }

    @Override
    public AutomatonElement visitTransition(TransitionContext context) {
        return new Transition(
                span(context),
                builders.names.build(context.source),
                builders.names.buildOptional(context.target),
                guard(context.guard()),
                builders.blocks.block(context.input),
                builders.blocks.block(context.output));
    }

    private Optional<Guard> guard(GuardContext context) {
        if (context == null) {
            return Optional.empty();
        }
        return Optional.of(
                new Guard(
                        span(context),
                        builders.names.buildOptional(context.name()),
                        builders.expressions.build(context.expression())));
    }
}

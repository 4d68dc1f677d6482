package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Statement;
import arcomat.model.Variable;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.InitialSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.tree.Name;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/** One automaton: names resolved, conditions on variables moved into guards. */
final class AutomatonLowering {
    /** Ways through statements that become a transition each. */
    private static final int MOST_WAYS = 64;

    /** Names, literals and operators of one value, where names stand for what was assigned. */
    private static final long LARGEST = 2_000;

    /** The same of one that says which of many ways is gone. */
    private static final long LARGEST_JOINED = 10_000;

    private final AutomatonSymbol symbol;
    private final Environment environment;
    private final List<Variable> variables;
    private final ExpressionLowering expressions;
    private final ValueLowering values;
    private final Turns turns = new Turns();
    private final Component.Profile profile;

    /**
     * @param outer what the component around it gives: ports, parameters, constants
     */
    AutomatonLowering(AutomatonSymbol symbol, Environment outer, Component.Profile profile) {
        this.symbol = symbol;
        this.profile = profile;
        this.variables = VariableLowering.lower(symbol.memory(), outer);
        this.environment = outer.withVariables(variables);
        this.expressions = new ExpressionLowering(environment);
        this.values = new ValueLowering(expressions);
    }

    Automaton lower() {
        return new Automaton(
                symbol.name(),
                Stereotypes.completion(symbol.stereotype("completion")),
                Stereotypes.omitted(symbol.stereotype("omitted")),
                Stereotypes.violated(symbol.stereotype("violated")),
                symbol.states().stream().map(StateSymbol::name).toList(),
                variables,
                symbol.initials().stream().map(this::initial).toList(),
                symbol.transitions().stream().flatMap(this::transitions).toList(),
                symbol.states().stream().map(StateSymbol::nameSpan).toList(),
                symbol.states().stream().map(AutomatonLowering::within).toList(),
                symbol.node().span());
    }

    private static List<String> within(StateSymbol state) {
        return state.node().within().stream().map(Name::text).toList();
    }

    private Automaton.Initial initial(InitialSymbol initial) {
        if (initial.actions().isPresent()) {
            // A law lets nothing be decided here, so there is one way.
            ActionPath path = ways(statement(initial.actions().get())).get(0);
            return new Automaton.Initial(
                    initial.state().orElseThrow().index(),
                    path.sent(),
                    path.assignments(),
                    initial.node().span());
        }
        return new Automaton.Initial(
                initial.state().orElseThrow().index(),
                sends(initial.items()),
                assignments(initial.items()),
                initial.node().span());
    }

    private Statement statement(ActionSymbol actions) {
        return StatementLowering.lower(actions, environment);
    }

    private List<ActionPath> ways(Statement statement) {
        return StatementWays.all(statement, profile);
    }

    /** Several where statements choose: one for each way through them. */
    private Stream<Automaton.Transition> transitions(TransitionSymbol transition) {
        TransitionCondition demand = demand(transition);
        List<Expression> guards = new ArrayList<>(demand.guards());
        guards.addAll(turns.denials(transition.node(), demand));
        if (transition.actions().isEmpty()) {
            List<ItemSymbol> output = transition.output();
            Optional<Expression> guard = conjunction(guards);
            return Stream.of(
                    transition(transition, demand, guard, sends(output), assignments(output)));
        }
        Statement statement = statement(transition.actions().get());
        if (statement.ways() > MOST_WAYS || Sizes.largest(statement) > LARGEST) {
            return joined(transition, demand, guards, statement);
        }
        List<ActionPath> paths = ways(statement);
        Automaton.Body body =
                new Automaton.Body(
                        conjunction(guards),
                        demand.matches(),
                        statement,
                        paths.size(),
                        Automaton.Standing.WAYS);
        return paths.stream()
                .map(path -> transition(transition, demand, guards, path))
                .map(each -> paths.size() == 1 ? each : each.of(body));
    }

    /** Too many ways to have a transition each: some are one, or all of them are. */
    private Stream<Automaton.Transition> joined(
            TransitionSymbol transition,
            TransitionCondition demand,
            List<Expression> guards,
            Statement statement) {
        Optional<List<ActionPath>> paths =
                StatementWays.joined(statement, profile, MOST_WAYS, LARGEST_JOINED);
        Optional<Expression> guard = conjunction(guards);
        Automaton.Body body =
                new Automaton.Body(
                        guard,
                        demand.matches(),
                        statement,
                        paths.map(List::size).orElse(1),
                        paths.isPresent() ? Automaton.Standing.JOINED : Automaton.Standing.WHOLE);
        if (paths.isEmpty()) {
            return Stream.of(transition(transition, demand, guard, List.of(), List.of()).of(body));
        }
        return paths.get().stream()
                .map(path -> transition(transition, demand, guards, path).of(body));
    }

    private Automaton.Transition transition(
            TransitionSymbol transition,
            TransitionCondition demand,
            List<Expression> guards,
            ActionPath path) {
        List<Expression> all = new ArrayList<>(guards);
        all.addAll(path.conditions());
        return transition(transition, demand, conjunction(all), path.sent(), path.assignments());
    }

    private static Optional<Expression> conjunction(List<Expression> guards) {
        return guards.isEmpty() ? Optional.empty() : Optional.of(Connectives.conjunction(guards));
    }

    private static Automaton.Transition transition(
            TransitionSymbol transition,
            TransitionCondition demand,
            Optional<Expression> guard,
            List<Automaton.Send> sends,
            List<Automaton.Assignment> assignments) {
        return new Automaton.Transition(
                transition.source().orElseThrow().index(),
                transition.target().orElseThrow().index(),
                guard,
                demand.matches(),
                sends,
                assignments,
                transition.node().rank(),
                transition.node().span());
    }

    private TransitionCondition demand(TransitionSymbol transition) {
        TransitionCondition demand = new TransitionCondition();
        transition.guard().ifPresent(g -> demand.add(expressions.lower(g.expression())));
        for (ItemSymbol item : transition.input()) {
            ValueSymbol target = target(item);
            if (target instanceof PortSymbol port) {
                demand.add(values.condition(port(port), item.value()));
            } else {
                demand.add(values.comparison(read(target, item), item.value()));
            }
        }
        return demand;
    }

    private Expression read(ValueSymbol target, ItemSymbol item) {
        if (target instanceof VariableSymbol variable) {
            return new Expression.VariableRead(expressions.variable(variable), item.node().span());
        }
        String name = ((ParameterSymbol) target).name();
        return new Expression.ParameterRead(
                Objects.requireNonNull(environment.parameters().get(name)), item.node().span());
    }

    private List<Automaton.Send> sends(List<ItemSymbol> items) {
        List<Automaton.Send> sends = new ArrayList<>();
        for (ItemSymbol item : items) {
            if (target(item) instanceof PortSymbol port) {
                sends.add(values.send(port(port), item.value()));
            }
        }
        return sends;
    }

    private List<Automaton.Assignment> assignments(List<ItemSymbol> items) {
        List<Automaton.Assignment> assignments = new ArrayList<>();
        for (ItemSymbol item : items) {
            if (target(item) instanceof VariableSymbol symbolOfVariable) {
                Variable variable = expressions.variable(symbolOfVariable);
                assignments.add(
                        new Automaton.Assignment(
                                variable,
                                expressions.lower(
                                        item.value().expressions().get(0), variable.type())));
            }
        }
        return assignments;
    }

    private static ValueSymbol target(ItemSymbol item) {
        return Lowering.resolved(item.target(), item.node().span());
    }

    private Port port(PortSymbol port) {
        return Objects.requireNonNull(environment.ports().get(port.name()));
    }
}

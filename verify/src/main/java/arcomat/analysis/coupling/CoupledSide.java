package arcomat.analysis.coupling;

import arcomat.analysis.reachability.Preconditions;
import arcomat.analysis.search.system.RunErrors;
import arcomat.analysis.smt.DataStep;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.model.Automaton.Transition;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.expression.Effect;
import arcomat.semantics.expression.Formulas;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.GivenUp;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * An automaton as one side of a comparison. Its variables are read as if they were ports with a
 * message in every slice; so its steps are told as those of any automaton are.
 */
final class CoupledSide {
    private final StepRelation relation;
    private final StepRelation opened;
    private final List<Preconditions> preconditions;
    private final Set<String> owned;
    private final List<Port> memory;

    /** By state, all that may happen there. */
    private final Map<Integer, InState> told = new HashMap<>();

    /**
     * What may happen in a state.
     *
     * @param behaviours all that it may do but for errors
     * @param errs when its run may end
     */
    private record InState(List<PossibleStep> behaviours, Expression errs) {}

    private CoupledSide(
            StepRelation relation, StepRelation opened, Set<String> owned, List<Port> memory) {
        this.relation = relation;
        this.opened = opened;
        this.owned = owned;
        this.memory = List.copyOf(memory);
        this.preconditions = Preconditions.of(opened.component().profile(), opened.automaton());
    }

    /**
     * @param name stands before the names of its variables
     * @param arguments one per parameter of the component
     * @throws GivenUp where its steps cannot be told like this
     */
    static CoupledSide of(
            String name, Component component, Automaton automaton, List<Value> arguments) {
        requireSlices(component);
        Map<String, Port> memory = new HashMap<>();
        List<Port> ports = new ArrayList<>();
        for (Variable variable : automaton.variables()) {
            Port port = port(name, variable);
            memory.put(variable.name(), port);
            ports.add(port);
        }
        List<Port> all = new ArrayList<>(component.ports());
        all.addAll(ports);
        Component opened =
                component.like(component.name(), all, component.body(), component.span());
        return new CoupledSide(
                relation(component, automaton, arguments),
                relation(opened, new OpenedAutomaton(memory).of(automaton), arguments),
                ComponentSemantics.owned(component, automaton),
                ports);
    }

    private static StepRelation relation(
            Component component, Automaton automaton, List<Value> arguments) {
        return ComponentSemantics.of(component, List.of(automaton), arguments).relations().get(0);
    }

    private static Port port(String name, Variable variable) {
        return new Port(
                name + "." + variable.name(),
                Port.Direction.IN,
                variable.type(),
                true,
                0,
                false,
                variable.span());
    }

    private static void requireSlices(Component component) {
        if (component.profile() == Component.Profile.EVENT_DRIVEN) {
            throw new GivenUp(component.name() + " handles events");
        }
        if (component.body() instanceof Component.Atomic atomic && !atomic.shown().isEmpty()) {
            throw new GivenUp("a port of " + component.name() + " shows a variable");
        }
    }

    /** Its variables, in the order of declaration. */
    List<Port> memory() {
        return memory;
    }

    List<Port> inputs() {
        return relation.component().inputs();
    }

    /** The names of its output ports. */
    List<String> outputs() {
        return relation.component().outputs().stream().map(Port::name).toList();
    }

    /** All that decides about what it does in a state. */
    List<Expression> expressions(int state) {
        List<Expression> all = new ArrayList<>(List.of(errs(state)));
        behaviours(state).forEach(each -> all.addAll(each.expressions()));
        return all;
    }

    Port output(String name) {
        return relation.component().port(name).orElseThrow();
    }

    /** Each with what is sent before anything is read. */
    List<StepRelation.Start> starts() {
        return relation.starts();
    }

    String state(int number) {
        return number == PossibleStep.CHAOS ? "chaos" : relation.automaton().states().get(number);
    }

    /** Its number, or -1 for a name that no state has. */
    int state(String name) {
        return relation.automaton().states().indexOf(name);
    }

    /** Whether any run may end in an error, as far as types tell. */
    boolean mayErr() {
        return RunErrors.arePossible(relation.automaton());
    }

    /** All that it may do in a state but for errors. */
    List<PossibleStep> behaviours(int state) {
        return told.computeIfAbsent(state, this::tell).behaviours;
    }

    /** When its run may end in a state. */
    Expression errs(int state) {
        return told.computeIfAbsent(state, this::tell).errs;
    }

    private InState tell(int state) {
        List<Transition> transitions = transitions(state);
        List<DataStep> steps = steps(state);
        List<PossibleStep> all = new ArrayList<>();
        Expression errs = Formulas.FALSE;
        for (int i = 0; i < steps.size(); i++) {
            DataStep step = steps.get(i);
            all.add(taken(transitions.get(i), step));
            errs = Formulas.or(errs, Formulas.and(step.tried(), Formulas.not(step.happens())));
        }
        if (completion() == Completion.ERROR) {
            errs = Formulas.or(unhandled(steps), errs);
        } else {
            all.add(completed(state, steps));
        }
        return new InState(all, errs);
    }

    private Completion completion() {
        return relation.automaton().completion();
    }

    private List<Transition> transitions(int state) {
        return opened.automaton().transitions().stream()
                .filter(each -> each.source() == state)
                .toList();
    }

    private List<DataStep> steps(int state) {
        Value[] nothing = new Value[memory.size()];
        List<Variable> variables = opened.automaton().variables();
        for (int i = 0; i < nothing.length; i++) {
            nothing[i] = variables.get(i).type().first();
        }
        return DataStep.outOf(new Configuration(state, nothing), opened, preconditions);
    }

    private static Expression unhandled(List<DataStep> steps) {
        Expression tried = steps.stream().map(DataStep::tried).reduce(Formulas.FALSE, Formulas::or);
        return Formulas.not(tried);
    }

    private PossibleStep taken(Transition transition, DataStep step) {
        Map<String, Emitted> sends = new LinkedHashMap<>();
        for (Port port : relation.component().outputs()) {
            List<Expression> values = step.sends().getOrDefault(port.name(), List.of());
            sends.put(
                    port.name(),
                    values.isEmpty()
                            ? Emitted.of(open(port, transition))
                            : Emitted.of(values.get(0)));
        }
        Map<String, Expression> after = new LinkedHashMap<>();
        for (int i = 0; i < step.stores().size(); i++) {
            String variable = transition.assignments().get(i).variable().name();
            after.put(port(variable).name(), step.stores().get(i));
        }
        String name = relation.automaton().arrow(transition);
        return new PossibleStep(step.happens(), sends, transition.target(), after, name);
    }

    private Port port(String variable) {
        List<String> names = relation.automaton().variables().stream().map(Variable::name).toList();
        return memory.get(names.indexOf(variable));
    }

    /** What a transition says about a port on which it sends no message that is computed. */
    private Sent open(Port port, Transition transition) {
        if (!owned.contains(port.name())) {
            return Effect.anything(port);
        }
        boolean silent = relation.automaton().omitted() == Automaton.Omitted.SILENT;
        return transition.sends().stream()
                .filter(send -> send.port().name().equals(port.name()))
                .findFirst()
                .map(
                        send ->
                                send.emission()
                                        .<Sent>match(
                                                m -> Sent.SILENCE,
                                                () -> Sent.SILENCE,
                                                Sent.AnyMessage::new))
                .orElse(silent ? Sent.SILENCE : Effect.anything(port));
    }

    private PossibleStep completed(int state, List<DataStep> steps) {
        boolean ignores = completion() == Completion.IGNORE;
        Map<String, Emitted> sends = new LinkedHashMap<>();
        for (Port port : relation.component().outputs()) {
            boolean silent = ignores && owned.contains(port.name());
            sends.put(port.name(), Emitted.of(silent ? Sent.SILENCE : Effect.anything(port)));
        }
        int target = completion() == Completion.CHAOS ? PossibleStep.CHAOS : state;
        return new PossibleStep(
                unhandled(steps), sends, target, Map.of(), "completion of " + state(state));
    }
}

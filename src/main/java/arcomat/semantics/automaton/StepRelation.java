package arcomat.semantics.automaton;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.expression.AbstractionOfInputs;
import arcomat.semantics.expression.DataFlow;
import arcomat.semantics.expression.DataSorts;
import arcomat.semantics.expression.Effect;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Guards;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Scope;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.expression.Term;
import arcomat.semantics.statement.Carried;
import arcomat.semantics.value.InputAbstraction;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;

/**
 * All steps of one automaton: a relation between configurations, inputs, outputs and next
 * configurations, completed, so that every input has a reaction (Rumpe 1996). Pure: it holds no
 * state, and every method may be called in any order.
 */
public final class StepRelation {
    private final Component component;
    private final Automaton automaton;

    private final List<ReadyTransition> transitions = new ArrayList<>();
    private final List<List<ReadyTransition>> byState = new ArrayList<>();
    private final List<AbstractionOfInputs> attentions = new ArrayList<>();
    private final List<Start> starts = new ArrayList<>();
    private final Optional<Value[]> held;
    private final Output silence;
    private final Output anything;
    private final Trace.Completed completed;
    private final Scope scope;
    private final ShownVariables shown;

    /**
     * @param owned names of the output ports that the automaton decides about; the others are free
     *     to it
     * @param arguments one per parameter of the component
     */
    StepRelation(
            Component component, Automaton automaton, Set<String> owned, List<Value> arguments) {
        this.component = component;
        this.automaton = automaton;
        this.held = held(component);
        this.completed = new Trace.Completed(automaton.completion());
        List<Port> outputs = component.outputs();
        anything = new Output(outputs.stream().map(Effect::anything).toList());
        silence =
                new Output(
                        outputs.stream()
                                .map(
                                        port ->
                                                owned.contains(port.name())
                                                        ? Sent.SILENCE
                                                        : Effect.anything(port))
                                .toList());
        scope = new Scope(component, arguments, automaton);
        shown = ShownVariables.of(component, automaton);
        prepareTransitions(owned, arguments);
        prepareStarts(owned);
    }

    /** What latched ports hold before their first message; empty where that is nothing. */
    private static Optional<Value[]> held(Component component) {
        return component.inputs().stream().allMatch(port -> port.first().isEmpty())
                ? Optional.empty()
                : Optional.of(
                        component.inputs().stream()
                                .map(port -> port.first().orElse(null))
                                .toArray(Value[]::new));
    }

    /** What an input carries, with what latched ports hold. */
    Value[] read(Input input) {
        if (held.isEmpty()) {
            return input.slots();
        }
        Value[] messages = input.slots().clone();
        for (int port = 0; port < messages.length; port++) {
            messages[port] = messages[port] == null ? held.get()[port] : messages[port];
        }
        return messages;
    }

    private void prepareTransitions(Set<String> owned, List<Value> arguments) {
        for (int i = 0; i < automaton.states().size(); i++) {
            byState.add(new ArrayList<>(2));
            attentions.add(new AbstractionOfInputs(component, scope));
        }
        Guards guards = Guards.judging(component.profile());
        for (int i = 0; i < automaton.transitions().size(); i++) {
            Automaton.Transition transition = automaton.transitions().get(i);
            Expression enabledWhen = enabledWhen(guards, transition);
            attentions.get(transition.source()).add(enabledWhen, transition);
            ReadyTransition ready =
                    new ReadyTransition(
                            component,
                            automaton,
                            Evaluation.compile(enabledWhen, scope),
                            effect(owned, transition.sends(), transition.assignments()),
                            carried(owned, arguments, transition),
                            new Trace.Taken(i, transition));
            transitions.add(ready);
            byState.get(transition.source()).add(ready);
        }
    }

    /** Of statements, what has to hold before they are looked at. */
    private Expression enabledWhen(Guards guards, Automaton.Transition transition) {
        return transition.isWhole()
                ? guards.enabledWhen(
                        automaton,
                        transition.with(
                                transition.guard(), transition.matches(), List.of(), List.of()))
                : guards.enabledWhen(automaton, transition);
    }

    private Optional<Carried> carried(
            Set<String> owned, List<Value> arguments, Automaton.Transition transition) {
        return transition
                .body()
                .filter(body -> transition.isWhole())
                .map(body -> new Carried(component, automaton, body, owned, arguments));
    }

    private void prepareStarts(Set<String> owned) {
        Value[] values = new Value[automaton.variables().size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = scope.first(component, automaton.variables().get(i));
        }
        Value[] nothing = new Value[component.inputs().size()];
        for (Automaton.Initial initial : automaton.initials()) {
            Effect effect = effect(owned, initial.sends(), initial.assignments());
            try {
                Value[] variables = effect.variables(nothing, values);
                starts.add(
                        new Start(
                                initial,
                                atStart(component, effect.output(nothing, values)),
                                new Configuration(initial.state(), variables)));
            } catch (Fault fault) {
                throw fault.in(component.name() + ", initial" + Fault.line(initial.span()));
            }
        }
    }

    private Effect effect(
            Set<String> owned, List<Automaton.Send> sends, List<Automaton.Assignment> assignments) {
        return new Effect(component, automaton, owned, sends, assignments, scope);
    }

    /** A port with delay 0 sends nothing before the first input is read. */
    static Output atStart(Component component, Output output) {
        if (component.profile() == Component.Profile.EVENT_DRIVEN) {
            return output;
        }
        List<Sent> sent = new ArrayList<>(output.ports());
        List<Port> ports = component.outputs();
        for (int i = 0; i < sent.size(); i++) {
            if (ports.get(i).delay() == 0) {
                sent.set(i, Sent.SILENCE);
            }
        }
        return new Output(sent);
    }

    public Component component() {
        return component;
    }

    /** What names mean in its expressions. */
    Scope scope() {
        return scope;
    }

    public Automaton automaton() {
        return automaton;
    }

    /**
     * Tells how the data of the automaton flow.
     *
     * @param ports places by the name of the port
     * @return the places of its variables, in the order of declaration
     */
    public int[] tellFlow(DataSorts sorts, Map<String, Integer> ports) {
        int[] variables =
                automaton.variables().stream().mapToInt(v -> sorts.place(v.type())).toArray();
        new DataFlow(sorts, scope, ports, variables).tell(automaton);
        shown.tellFlow(sorts, ports, variables);
        for (Port port : component.inputs()) {
            int place = Objects.requireNonNull(ports.get(port.name()));
            port.first().ifPresent(value -> sorts.mention(place, value));
        }
        return variables;
    }

    /** An expression of the automaton, with values in the place of all names but those of ports. */
    public Expression reduced(Expression expression, Configuration configuration) {
        return scope.reduced(expression, configuration.slots());
    }

    /** What the reactions in a configuration depend on. */
    public InputAbstraction abstraction(Configuration configuration) {
        return configuration.isState()
                ? attentions.get(configuration.state()).with(configuration.slots())
                : InputAbstraction.none(component.inputs().size());
    }

    /** The alternatives to begin with, in text order. */
    public List<Start> starts() {
        return List.copyOf(starts);
    }

    /**
     * What may happen in a step of one automaton.
     *
     * @param reactions ways to go on, in text order
     * @param errors ways in which the run ends, in text order
     */
    public record Prospect(List<Reaction> reactions, List<RunError> errors) {}

    /**
     * All that may happen. Each enabled transition is a possibility of its own: one that goes wrong
     * forbids none of the others. So is one whose guard goes wrong.
     */
    public Prospect prospect(Configuration before, Input input) {
        List<Reaction> reactions = new ArrayList<>(1);
        List<RunError> errors = List.of();
        Value[] messages = read(input);
        for (ReadyTransition each : leaving(before)) {
            try {
                if (each.isEnabled(messages, before.slots())) {
                    reactions.add(take(each, before, messages));
                }
            } catch (Fault fault) {
                errors =
                        plus(
                                errors,
                                new RunError(each.cause(), String.valueOf(fault.getMessage())));
            }
        }
        if (reactions.isEmpty() && errors.isEmpty()) {
            Reaction completion = complete(before);
            if (completion.next() == Configuration.ERROR) {
                errors = List.of(new RunError(completed, forbids(before)));
            } else {
                reactions.add(completion);
            }
        }
        return new Prospect(reactions, errors);
    }

    /** That a completion forbids an input, in words. */
    public String forbids(Configuration before) {
        return Fault.place(component, automaton, before.state())
                + ": the automaton forbids this input";
    }

    /**
     * What the guards say of an input.
     *
     * @param enabled the transitions that may be taken, in text order
     * @param faults of the guards that go wrong
     */
    public record Choices(List<Trace.Taken> enabled, List<Fault> faults) {}

    /** The transitions that may be taken: a guard that goes wrong forbids none of the others. */
    public Choices choices(Configuration before, Input input) {
        List<Trace.Taken> enabled = List.of();
        List<Fault> faults = List.of();
        Value[] messages = read(input);
        for (ReadyTransition each : leaving(before)) {
            try {
                boolean may = each.isEnabled(messages, before.slots());
                enabled = may ? plus(enabled, each.cause()) : enabled;
            } catch (Fault fault) {
                faults = plus(faults, fault);
            }
        }
        return new Choices(enabled, faults);
    }

    /** Whether a condition is true; neither where it is undefined nor where it goes wrong. */
    public BiPredicate<Configuration, Input> condition(Expression expression) {
        Term condition = Evaluation.compile(expression, scope);
        return (configuration, input) -> {
            try {
                return condition.isTrue(read(input), configuration.slots());
            } catch (Fault fault) {
                return false;
            }
        };
    }

    /** The transitions that may be taken, in text order. */
    public List<Trace.Taken> enabled(Configuration before, Input input) {
        List<Trace.Taken> enabled = List.of();
        Value[] messages = read(input);
        for (ReadyTransition each : leaving(before)) {
            if (each.isEnabled(messages, before.slots())) {
                enabled = enabled.isEmpty() ? List.of(each.cause()) : plus(enabled, each.cause());
            }
        }
        return enabled;
    }

    /** The first of the enabled transitions; the guards behind it are not looked at. */
    public Optional<Trace.Taken> firstEnabled(Configuration before, Input input) {
        Value[] messages = read(input);
        for (ReadyTransition each : leaving(before)) {
            if (each.isEnabled(messages, before.slots())) {
                return Optional.of(each.cause());
            }
        }
        return Optional.empty();
    }

    private List<ReadyTransition> leaving(Configuration before) {
        return before.isState() ? byState.get(before.state()) : List.of();
    }

    static <T> List<T> plus(List<T> list, T next) {
        List<T> longer = new ArrayList<>(list);
        longer.add(next);
        return longer;
    }

    /**
     * The reaction of one enabled transition.
     *
     * @throws Fault where a right-hand side goes wrong
     */
    public Reaction take(Trace.Taken taken, Configuration before, Input input) {
        return take(transitions.get(taken.index()), before, read(input));
    }

    private Reaction take(ReadyTransition transition, Configuration before, Value[] messages) {
        return shown.in(transition.reaction(messages, before.slots()));
    }

    /** The reaction where no transition is enabled. */
    public Reaction complete(Configuration before) {
        return shown.in(completion(before));
    }

    private Reaction completion(Configuration before) {
        if (!before.isState()) {
            return new Reaction(completed, anything, before);
        }
        Completion completion = automaton.completion();
        return switch (completion) {
            case CHAOS -> new Reaction(completed, anything, Configuration.CHAOS);
            case OUTPUT -> new Reaction(completed, anything, before);
            case IGNORE -> new Reaction(completed, silence, before);
            case ERROR -> new Reaction(completed, anything, Configuration.ERROR);
        };
    }

    /** One way to begin: an initial clause with what it sends and where the automaton is then. */
    public record Start(Automaton.Initial initial, Output output, Configuration configuration) {}

    /**
     * One way to go on: what is sent and where the automaton is afterwards.
     *
     * @param cause the transition, or the completion where none is enabled
     */
    public record Reaction(Trace.Cause cause, Output output, Configuration next) {}

    /**
     * One way in which a run ends: a transition goes wrong, or the completion forbids the input.
     *
     * @param cause the transition or the completion
     * @param message what goes wrong and where, in words
     */
    public record RunError(Trace.Cause cause, String message) {}
}

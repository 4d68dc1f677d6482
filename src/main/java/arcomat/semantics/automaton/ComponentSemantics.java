package arcomat.semantics.automaton;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Statement;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.automaton.StepRelation.RunError;
import arcomat.semantics.automaton.StepRelation.Start;
import arcomat.semantics.expression.Effect;
import arcomat.semantics.expression.Output;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * What an atomic component does. Several automata are a conjunction: a step of the component is a
 * step of each of them with one output that all of them allow. Without an automaton nothing is
 * promised. Pure, like the relations that it is made of.
 */
public final class ComponentSemantics {
    private final Component component;
    private final List<StepRelation> relations = new ArrayList<>();

    /** A search that counts how often it asks shall not end where networks are of usual size. */
    private static final int PARTS_AT_ONCE = 256;

    private ComponentSemantics(Component component) {
        this.component = component;
    }

    /**
     * The behaviour of an atomic component, or of a platform component, about which the model says
     * nothing.
     *
     * @param arguments one per parameter
     */
    public static ComponentSemantics of(Component component, List<Value> arguments) {
        List<Automaton> automata =
                component.body() instanceof Component.Atomic atomic && !component.platform()
                        ? atomic.automata()
                        : List.of();
        return of(component, automata, arguments);
    }

    /** Those of the instances of a network, in their order. */
    public static List<ComponentSemantics> ofParts(Network network) {
        return ofParts(network, () -> {});
    }

    /**
     * As above.
     *
     * @param goOn asked after every few hundred of them; it may throw what ends the work
     */
    public static List<ComponentSemantics> ofParts(Network network, Runnable goOn) {
        List<ComponentSemantics> behaviours = new ArrayList<>(network.instances().size());
        for (Network.Instance part : network.instances()) {
            behaviours.add(of(part.component(), part.arguments()));
            if (behaviours.size() % PARTS_AT_ONCE == 0) {
                goOn.run();
            }
        }
        return List.copyOf(behaviours);
    }

    /**
     * Some automata of a component, perhaps with another completion.
     *
     * @param automata of the component, or made from them
     */
    public static ComponentSemantics of(
            Component component, List<Automaton> automata, List<Value> arguments) {
        ComponentSemantics behaviour = new ComponentSemantics(component);
        for (Automaton automaton : automata) {
            Set<String> owned = owned(component, automaton);
            behaviour.relations.add(new StepRelation(component, automaton, owned, arguments));
        }
        return behaviour;
    }

    /**
     * Names of the outputs that an automaton decides about: those that it writes, and those that no
     * automaton of the component writes, which belong to all of them. Where all take part, such a
     * port is open only if each of them leaves it open, so one more automaton never allows more;
     * one that is total has a message in every slice, and nobody says which. A sole automaton on a
     * decomposed component is a requirement about what it writes.
     */
    public static Set<String> owned(Component component, Automaton automaton) {
        Set<String> owned = written(automaton);
        boolean atomic = component.body() instanceof Component.Atomic;
        if (atomic || component.automata().size() > 1) {
            Set<String> unwritten =
                    component.outputs().stream()
                            .filter(port -> !port.total())
                            .map(Port::name)
                            .collect(Collectors.toCollection(HashSet::new));
            component.automata().forEach(each -> unwritten.removeAll(written(each)));
            owned.addAll(unwritten);
        }
        return owned;
    }

    /** Names of the outputs that an automaton writes. */
    public static Set<String> written(Automaton automaton) {
        Set<String> names = new HashSet<>();
        automaton.initials().forEach(i -> i.sends().forEach(s -> names.add(s.port().name())));
        for (Automaton.Transition transition : automaton.transitions()) {
            transition.sends().forEach(send -> names.add(send.port().name()));
            if (transition.isWhole()) {
                Statement statement = transition.body().orElseThrow().statement();
                statement.sends().forEach(send -> names.add(send.port().name()));
            }
        }
        return names;
    }

    public Component component() {
        return component;
    }

    /** One per automaton, in text order. */
    public List<StepRelation> relations() {
        return List.copyOf(relations);
    }

    /**
     * What the steps of all automata together look at.
     *
     * @param configurations one per automaton
     */
    public InputAbstraction abstraction(List<Configuration> configurations) {
        InputAbstraction all = InputAbstraction.none(component.inputs().size());
        for (int i = 0; i < configurations.size(); i++) {
            all = all.and(relations.get(i).abstraction(configurations.get(i)));
        }
        return all;
    }

    /** A beginning of all automata at once. */
    public record JointStart(List<Start> starts, Output output) {
        /** Where it begins: one configuration per automaton. */
        public List<Configuration> configurations() {
            return starts.stream().map(Start::configuration).toList();
        }
    }

    /** A step of all automata at once. */
    public record JointReaction(List<Reaction> reactions, Output output) {
        /** Where it leads: one configuration per automaton. */
        public List<Configuration> next() {
            return reactions.stream().map(Reaction::next).toList();
        }
    }

    /** All beginnings, in text order of the first automaton, then the second, and so on. */
    public List<JointStart> starts() {
        return starts(() -> {});
    }

    /**
     * @param between called before each combination; may throw to give up, where there are many
     */
    public List<JointStart> starts(Runnable between) {
        Output open = StepRelation.atStart(component, anything());
        List<JointStart> joint = List.of(new JointStart(List.of(), open));
        for (StepRelation relation : relations) {
            List<JointStart> longer = new ArrayList<>();
            for (JointStart prefix : joint) {
                for (Start start : relation.starts()) {
                    between.run();
                    Optional<Output> output = prefix.output.meet(start.output());
                    output.ifPresent(
                            o ->
                                    longer.add(
                                            new JointStart(
                                                    StepRelation.plus(prefix.starts, start), o)));
                }
            }
            joint = longer;
        }
        return joint;
    }

    /**
     * One way in which the run ends: every automaton ends it.
     *
     * @param errors one per automaton
     */
    public record JointError(List<RunError> errors) {
        public JointError {
            errors = List.copyOf(errors);
        }

        public List<Trace.Cause> causes() {
            return errors.stream().map(RunError::cause).toList();
        }

        /** What goes wrong, in words. */
        public String message() {
            return errors.stream().map(RunError::message).collect(Collectors.joining("; "));
        }
    }

    /**
     * All that may happen in a step.
     *
     * @param reactions ways to go on, in text order of the first automaton, then the second
     * @param errors ways in which the run ends
     */
    public record Prospect(List<JointReaction> reactions, List<JointError> errors) {
        public Prospect {
            reactions = List.copyOf(reactions);
            errors = List.copyOf(errors);
        }

        /** Whether no output satisfies all automata, and not even an error would. */
        public boolean isContradiction() {
            return reactions.isEmpty() && errors.isEmpty();
        }
    }

    /** All that may happen; nothing where the automata contradict each other. */
    public Prospect prospect(List<Configuration> before, Input input) {
        return prospect(before, input, () -> {});
    }

    /**
     * All that may happen: what each of the automata allows. So a run may go on with an output that
     * an alternative of each allows, and may end in an error only where each of them may.
     *
     * @param between called before each combination; may throw to give up, where there are many
     */
    public Prospect prospect(List<Configuration> before, Input input, Runnable between) {
        if (relations.size() == 1) {
            return sole(relations.get(0).prospect(before.get(0), input));
        }
        List<JointReaction> joint = List.of(new JointReaction(List.of(), anything()));
        List<RunError> errors = new ArrayList<>();
        for (int i = 0; i < relations.size(); i++) {
            StepRelation.Prospect own = relations.get(i).prospect(before.get(i), input);
            own.errors().stream().findFirst().ifPresent(errors::add);
            joint = joined(joint, own.reactions(), between);
        }
        boolean all = !relations.isEmpty() && errors.size() == relations.size();
        return new Prospect(joint, all ? List.of(new JointError(errors)) : List.of());
    }

    private static Prospect sole(StepRelation.Prospect own) {
        List<JointReaction> reactions = new ArrayList<>(own.reactions().size());
        for (Reaction each : own.reactions()) {
            reactions.add(new JointReaction(List.of(each), each.output()));
        }
        List<JointError> errors = new ArrayList<>(own.errors().size());
        for (RunError each : own.errors()) {
            errors.add(new JointError(List.of(each)));
        }
        return new Prospect(reactions, errors);
    }

    private static List<JointReaction> joined(
            List<JointReaction> prefixes, List<Reaction> reactions, Runnable between) {
        List<JointReaction> longer = new ArrayList<>();
        for (JointReaction prefix : prefixes) {
            for (Reaction reaction : reactions) {
                between.run();
                prefix.output
                        .meet(reaction.output())
                        .map(
                                both ->
                                        new JointReaction(
                                                StepRelation.plus(prefix.reactions, reaction),
                                                both))
                        .ifPresent(longer::add);
            }
        }
        return longer;
    }

    private Output anything() {
        return new Output(component.outputs().stream().map(Effect::anything).toList());
    }
}

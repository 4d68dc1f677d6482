package arcomat.semantics;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;

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
public final class Behaviour {
    private final Component component;
    private final List<StepRelation> relations = new ArrayList<>();

    private Behaviour(Component component) {
        this.component = component;
    }

    /**
     * The behaviour of an atomic component, or of a platform component, about which the model says
     * nothing.
     *
     * @param arguments one per parameter
     */
    public static Behaviour of(Component component, List<Value> arguments) {
        List<Automaton> automata =
                component.body() instanceof Component.Atomic atomic && !component.platform()
                        ? atomic.automata()
                        : List.of();
        return of(component, automata, arguments);
    }

    /**
     * Some automata of a component, perhaps with another completion.
     *
     * @param automata of the component, or made from them
     */
    public static Behaviour of(
            Component component, List<Automaton> automata, List<Value> arguments) {
        Behaviour behaviour = new Behaviour(component);
        for (Automaton automaton : automata) {
            Set<String> owned = owned(component, automaton);
            behaviour.relations.add(new StepRelation(component, automaton, owned, arguments));
        }
        return behaviour;
    }

    /**
     * Names of the outputs that an automaton decides about: a sole automaton of an atomic component
     * all of them, any other those that it writes.
     */
    public static Set<String> owned(Component component, Automaton automaton) {
        boolean sole =
                component.body() instanceof Component.Atomic atomic
                        && atomic.automata().size() == 1;
        return sole ? names(component.outputs()) : written(automaton);
    }

    private static Set<String> names(List<Port> ports) {
        return ports.stream().map(Port::name).collect(Collectors.toSet());
    }

    private static Set<String> written(Automaton automaton) {
        Set<String> names = new HashSet<>();
        automaton.initials().forEach(i -> i.sends().forEach(s -> names.add(s.port().name())));
        automaton.transitions().forEach(t -> t.sends().forEach(s -> names.add(s.port().name())));
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
    public Attention attention(List<Configuration> configurations) {
        Attention all = Attention.none(component.inputs().size());
        for (int i = 0; i < configurations.size(); i++) {
            all = all.and(relations.get(i).attention(configurations.get(i)));
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
                            o -> longer.add(new JointStart(plus(prefix.starts, start), o)));
                }
            }
            joint = longer;
        }
        return joint;
    }

    /**
     * All steps; none where the automata contradict each other.
     *
     * @param before one configuration per automaton
     * @throws Fault where a right-hand side goes wrong
     */
    public List<JointReaction> reactions(List<Configuration> before, Input input) {
        return reactions(before, input, () -> {});
    }

    /**
     * @param between called before each combination; may throw to give up, where there are many
     */
    public List<JointReaction> reactions(
            List<Configuration> before, Input input, Runnable between) {
        if (relations.size() == 1) {
            return single(before.get(0), input);
        }
        List<JointReaction> joint = List.of(new JointReaction(List.of(), anything()));
        for (int i = 0; i < relations.size(); i++) {
            List<Reaction> reactions = relations.get(i).reactions(before.get(i), input);
            List<JointReaction> longer = new ArrayList<>();
            for (JointReaction prefix : joint) {
                for (Reaction reaction : reactions) {
                    between.run();
                    Optional<Output> output = prefix.output.meet(reaction.output());
                    output.ifPresent(
                            o ->
                                    longer.add(
                                            new JointReaction(
                                                    plus(prefix.reactions, reaction), o)));
                }
            }
            joint = longer;
        }
        return joint;
    }

    /**
     * All that may happen in a step.
     *
     * @param faults each ends the run, where it happens
     */
    public record Prospect(List<JointReaction> reactions, List<Fault> faults) {
        public Prospect {
            reactions = List.copyOf(reactions);
            faults = List.copyOf(faults);
        }
    }

    /**
     * All steps, where some transitions may go wrong. Of a sole automaton, a transition that goes
     * wrong spares those that may be taken instead; a guard that does, or one of several automata,
     * spares none.
     *
     * @param between called before each combination; may throw to give up, where there are many
     */
    public Prospect prospect(List<Configuration> before, Input input, Runnable between) {
        try {
            return relations.size() == 1
                    ? prospect(relations.get(0), before.get(0), input)
                    : new Prospect(reactions(before, input, between), List.of());
        } catch (Fault fault) {
            return new Prospect(List.of(), List.of(fault));
        }
    }

    private static Prospect prospect(StepRelation relation, Configuration before, Input input) {
        List<JointReaction> reactions = new ArrayList<>();
        List<Fault> faults = new ArrayList<>(0);
        List<Trace.Taken> enabled = relation.enabled(before, input);
        if (enabled.isEmpty()) {
            reactions.add(joint(relation.complete(before)));
        }
        for (Trace.Taken taken : enabled) {
            try {
                reactions.add(joint(relation.take(taken, before, input)));
            } catch (Fault fault) {
                faults.add(fault);
            }
        }
        return new Prospect(reactions, faults);
    }

    private static JointReaction joint(Reaction reaction) {
        return new JointReaction(List.of(reaction), reaction.output());
    }

    private List<JointReaction> single(Configuration before, Input input) {
        List<Reaction> reactions = relations.get(0).reactions(before, input);
        return reactions.size() == 1
                ? List.of(joint(reactions.get(0)))
                : reactions.stream().map(Behaviour::joint).toList();
    }

    private Output anything() {
        return new Output(component.outputs().stream().map(Effect::anything).toList());
    }

    private static <T> List<T> plus(List<T> list, T last) {
        List<T> longer = new ArrayList<>(list);
        longer.add(last);
        return longer;
    }
}

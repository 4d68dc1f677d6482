package arcomat.analysis.coverage;

import arcomat.analysis.coverage.Stimuli.Stimulus;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The configurations of an atomic component with one step of each kind between them, on demand.
 * Those in which nothing is promised any more are left out.
 */
final class ReachabilityGraph {
    /** So many letters are tried where not all are. */
    private static final long MOST_SAMPLES = 200_000;

    /** So many letters that are tried cost as much as a configuration. */
    private static final int LETTERS_OF_A_STATE = 64;

    private record Key(List<Configuration> configurations, List<Value> latched) {}

    /** A configuration of each automaton and the latched values. */
    static final class Node {
        private final Key key;
        private @Nullable List<Step> steps;

        private Node(Key key) {
            this.key = key;
        }
    }

    /** A way to begin, with what is sent before anything is read. */
    record Beginning(Node node, Letter sent) {}

    /**
     * @param input what the automata read; empty where only a latched port changes
     * @param taken the transitions that take part
     * @param sent what is left open is sent as code would send it
     */
    record Step(
            Node from,
            Letter letter,
            Optional<Input> input,
            List<Goal> taken,
            Letter sent,
            Node to) {}

    private final Component component;
    private final Budget budget;
    private final ComponentSemantics behaviour;
    private final Stimuli stimuli;
    private final Obstacles obstacles;
    private final Map<Key, Node> nodes = new LinkedHashMap<>();
    private long tried;

    ReachabilityGraph(Promise promise, Budget budget) {
        this.component = promise.component();
        this.budget = budget;
        this.behaviour = ComponentSemantics.of(component, promise.arguments());
        this.stimuli = new Stimuli(behaviour, promise.arguments(), budget::isSpent);
        this.obstacles = new Obstacles(behaviour);
    }

    /** A way to begin, with what is sent before anything is read. */
    List<Beginning> beginnings() {
        List<Value> nothing = Arrays.asList(new Value[component.inputs().size()]);
        return behaviour.starts(budget::insist).stream()
                .map(
                        start ->
                                new Beginning(
                                        node(new Key(start.configurations(), nothing)),
                                        letter(start.output())))
                .toList();
    }

    /**
     * Why to look no further. Where not all letters are tried, there is no end to it: some have to
     * be enough.
     */
    Optional<String> exhausted() {
        if (stimuli.sampled().isPresent() && tried > MOST_SAMPLES) {
            return stimuli.sampled();
        }
        long explored = nodes.size() + tried / LETTERS_OF_A_STATE;
        return Optional.ofNullable(budget.exhausted(explored));
    }

    /** What was not tried, where that is something. */
    Optional<String> sampled() {
        return stimuli.sampled();
    }

    /** What keeps transitions from being taken, as far as was looked. */
    Obstacles obstacles() {
        return obstacles;
    }

    private Node node(Key key) {
        return nodes.computeIfAbsent(key, Node::new);
    }

    /** What the component would be without a transition. */
    MissingTransition without(Goal goal) {
        return new MissingTransition(this, behaviour, goal, budget);
    }

    /** How many configurations were met. */
    int size() {
        return nodes.size();
    }

    /** The steps out of a configuration, one of each kind. */
    List<Step> steps(Node node) {
        if (node.steps == null) {
            node.steps = List.copyOf(compute(node));
        }
        return node.steps;
    }

    private record Effect(List<Goal> taken, Letter sent, Node to) {}

    private Collection<Step> compute(Node node) {
        obstacles.visited(node.key.configurations);
        Map<Effect, Step> steps = new LinkedHashMap<>();
        for (Stimulus stimulus : stimuli.of(node.key.configurations, node.key.latched)) {
            budget.insist();
            tried++;
            for (Effect effect : effects(node, stimulus)) {
                steps.putIfAbsent(
                        effect,
                        new Step(
                                node,
                                stimulus.letter(),
                                stimulus.input(),
                                effect.taken,
                                effect.sent,
                                effect.to));
            }
        }
        return steps.values();
    }

    private List<Effect> effects(Node node, Stimulus stimulus) {
        if (stimulus.input().isEmpty()) {
            Node after = node(new Key(node.key.configurations, stimulus.latched()));
            return List.of(new Effect(List.of(), Letter.SILENCE, after));
        }
        List<Configuration> before = node.key.configurations;
        Prospect prospect = behaviour.prospect(before, stimulus.input().get(), budget::insist);
        obstacles.wanted(before, stimulus.input().get(), !prospect.errors().isEmpty());
        List<Effect> effects = new ArrayList<>();
        for (JointReaction reaction : prospect.reactions()) {
            List<Configuration> after = reaction.next();
            boolean lost = after.stream().allMatch(next -> next == Configuration.CHAOS);
            if (!lost) {
                Node next = node(new Key(after, stimulus.latched()));
                effects.add(new Effect(taken(reaction), letter(reaction.output()), next));
            }
        }
        return effects;
    }

    private List<Goal> taken(JointReaction reaction) {
        List<Goal> taken = new ArrayList<>();
        for (int i = 0; i < reaction.reactions().size(); i++) {
            if (reaction.reactions().get(i).cause() instanceof Trace.Taken cause) {
                taken.add(goal(i, cause));
            }
        }
        return taken;
    }

    private Goal goal(int relation, Trace.Taken cause) {
        return new Goal(behaviour.relations().get(relation).automaton(), cause.index());
    }

    /** What is left open is sent as a run without random choices sends it. */
    private Letter letter(Output output) {
        Map<String, List<Value>> messages = new LinkedHashMap<>();
        for (int i = 0; i < output.ports().size(); i++) {
            Port port = component.outputs().get(i);
            Sent sent = output.ports().get(i);
            if (sent instanceof Sent.Messages certain) {
                messages.put(port.name(), certain.values());
            } else if (sent instanceof Sent.AnyMessage) {
                messages.put(port.name(), List.of(port.type().first()));
            }
        }
        return new Letter(messages);
    }

    /**
     * A shortest word to a step with one of some transitions, at most so long.
     *
     * @return empty where there is none
     */
    List<Step> path(List<Node> from, Set<Goal> wanted, int longest) {
        Map<Node, Step> arrival = new HashMap<>();
        from.forEach(node -> arrival.put(node, null));
        List<Node> level = from;
        for (int length = 1; length <= longest && !level.isEmpty(); length++) {
            List<Node> next = new ArrayList<>();
            for (Node node : level) {
                for (Step step : steps(node)) {
                    if (step.taken.stream().anyMatch(wanted::contains)) {
                        return word(step, arrival);
                    }
                    if (!arrival.containsKey(step.to)) {
                        arrival.put(step.to, step);
                        next.add(step.to);
                    }
                }
            }
            level = next;
        }
        return List.of();
    }

    private static List<Step> word(Step last, Map<Node, Step> arrival) {
        Deque<Step> word = new ArrayDeque<>();
        for (Step step = last; step != null; step = arrival.get(step.from)) {
            word.addFirst(step);
        }
        return List.copyOf(word);
    }
}

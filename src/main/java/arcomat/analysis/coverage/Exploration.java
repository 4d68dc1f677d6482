package arcomat.analysis.coverage;

import arcomat.analysis.coverage.Stimuli.Stimulus;
import arcomat.analysis.coverage.TransitionTests.Uncovered;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.FirstValue;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.Behaviour;
import arcomat.semantics.automaton.Behaviour.JointReaction;
import arcomat.semantics.automaton.Behaviour.JointStart;
import arcomat.semantics.automaton.Behaviour.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.GivenUp;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The configurations of an atomic component that can be reached, breadth first, with one step of
 * each kind between them, until every transition has been met. Configurations in which nothing is
 * promised any more are not entered.
 */
final class Exploration {
    /** So many letters are tried where not all are. */
    private static final long MOST_SAMPLES = 200_000;

    /** So many letters that are tried cost as much as a configuration. */
    private static final int LETTERS_OF_A_STATE = 64;

    private record Key(List<Configuration> configurations, List<Value> latched) {}

    /** A configuration of each automaton and the latched values. */
    static final class Node {
        private final Key key;
        private List<Step> steps;

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

    private final Promise promise;
    private final Budget budget;
    private final Behaviour behaviour;
    private final Stimuli stimuli;
    private final List<Goal> goals = new ArrayList<>();
    private final Set<Goal> reached = new LinkedHashSet<>();
    private final Obstacles obstacles;
    private final Map<Key, Node> nodes = new LinkedHashMap<>();
    private final List<Beginning> beginnings = new ArrayList<>();
    private String stopped;
    private long tried;

    Exploration(Promise promise, Budget budget) {
        this.promise = promise;
        behaviour = Behaviour.of(promise.component(), promise.arguments());
        stimuli = new Stimuli(behaviour, promise.arguments());
        obstacles = new Obstacles(behaviour);
        promise.automata()
                .forEach(
                        automaton -> {
                            for (int i = 0; i < automaton.transitions().size(); i++) {
                                goals.add(new Goal(automaton, i));
                            }
                        });
        this.budget = budget;
        try {
            explore();
        } catch (GivenUp inTheMiddle) {
            stopped = inTheMiddle.getMessage();
        }
        reached.retainAll(goals);
    }

    private void explore() {
        Value[] nothing = new Value[promise.component().inputs().size()];
        Deque<Node> waiting = new ArrayDeque<>();
        for (JointStart start : behaviour.starts(budget::insist)) {
            Node node = node(new Key(start.configurations(), Arrays.asList(nothing)));
            beginnings.add(new Beginning(node, letter(start.output())));
            waiting.add(node);
        }
        Set<Node> seen = new HashSet<>(waiting);
        while (!waiting.isEmpty() && !reached.containsAll(goals)) {
            stopped = exhausted();
            if (stopped != null) {
                return;
            }
            for (Step step : steps(waiting.remove())) {
                reached.addAll(step.taken);
                if (seen.add(step.to)) {
                    waiting.add(step.to);
                }
            }
        }
    }

    /** Where not all letters are tried, there is no end to it: some have to be enough. */
    private String exhausted() {
        if (stimuli.sampled().isPresent() && tried > MOST_SAMPLES) {
            return stimuli.sampled().get();
        }
        return budget.exhausted(nodes.size() + tried / LETTERS_OF_A_STATE);
    }

    private Node node(Key key) {
        return nodes.computeIfAbsent(key, Node::new);
    }

    /** What the component would be without a transition. */
    Absence without(Goal goal) {
        return new Absence(this, behaviour, goal, budget);
    }

    /** The transitions that are asked for, in text order. */
    List<Goal> goals() {
        return goals;
    }

    /** Those that can be taken. */
    Set<Goal> reached() {
        return reached;
    }

    List<Beginning> beginnings() {
        return beginnings;
    }

    /** How many configurations were met. */
    int size() {
        return nodes.size();
    }

    /** Why not everything was looked at, where that is so. */
    Optional<String> stopped() {
        return Optional.ofNullable(stopped).or(stimuli::sampled);
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
        Component component = promise.component();
        Map<String, List<Value>> messages = new LinkedHashMap<>();
        for (int i = 0; i < output.ports().size(); i++) {
            Port port = component.outputs().get(i);
            Sent sent = output.ports().get(i);
            if (sent instanceof Sent.Messages certain) {
                messages.put(port.name(), certain.values());
            } else if (sent instanceof Sent.AnyMessage) {
                messages.put(port.name(), List.of(FirstValue.of(port.type())));
            }
        }
        return new Letter(messages);
    }

    /** Why a transition has not been met. */
    Uncovered whyNot(Goal goal) {
        return obstacles.of(goal, stopped());
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

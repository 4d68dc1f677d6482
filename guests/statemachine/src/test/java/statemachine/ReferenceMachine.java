package statemachine;

import statemachine.DrawnMachine.Move;
import statemachine.DrawnMachine.Node;
import statemachine.DrawnMachine.Reads;
import statemachine.DrawnMachine.Value;
import statemachine.DrawnMachine.Write;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;

/**
 * What a machine does, said once more and to be read: states are left and entered one after the
 * other, and each action works on what the one before has left behind.
 */
final class ReferenceMachine {
    private final DrawnMachine machine;

    ReferenceMachine(DrawnMachine machine) {
        this.machine = machine;
    }

    /**
     * Between two slices.
     *
     * @param active the simple state that it is in
     * @param last by the name of a state, the simple state in it that was left last
     */
    record Situation(String active, Map<String, String> last, Map<String, Integer> variables) {}

    /** Two messages on a port in one step: the machine means nothing. */
    static final class SentTwice extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    /**
     * @param sent by port
     */
    record Reaction(Map<String, Integer> sent, Situation next) {}

    Reaction start() {
        Step step = new Step(Map.of(), Map.of("n", 0, "m", 0), Optional.empty());
        step.begin(machine.root());
        return step.reaction();
    }

    /**
     * All that may happen in a slice.
     *
     * @param a the message, if there is one
     */
    List<Reaction> reactions(Situation before, Optional<Boolean> a) {
        List<Move> enabled = enabled(before, a);
        return enabled.isEmpty()
                ? List.of(meanwhile(before, a))
                : first(enabled).stream().map(move -> step(move, before, a).reaction()).toList();
    }

    private List<Move> enabled(Situation before, Optional<Boolean> a) {
        return machine.moves().stream()
                .filter(move -> path(before.active()).contains(node(move.source())))
                .filter(move -> isEnabled(move, before, a))
                .filter(move -> step(move, before, a).isPossible())
                .toList();
    }

    private Step step(Move move, Situation before, Optional<Boolean> a) {
        Step step = new Step(before.last(), before.variables(), a);
        step.take(move, before.active());
        return step;
    }

    /** Those that come first, if somebody says who does. */
    private List<Move> first(List<Move> enabled) {
        if (machine.priority().isEmpty()) {
            return enabled;
        }
        IntStream depths = enabled.stream().mapToInt(move -> path(move.source()).size());
        int first = (machine.priority().equals("inner") ? depths.max() : depths.min()).orElse(0);
        return enabled.stream().filter(move -> path(move.source()).size() == first).toList();
    }

    /**
     * What is done where no transition is enabled, from the outermost state on; nothing at all, if
     * something needs a message that is not there.
     */
    private Reaction meanwhile(Situation before, Optional<Boolean> a) {
        Step step = new Step(before.last(), before.variables(), a);
        step.active = before.active();
        path(before.active()).forEach(each -> each.during().forEach(step::write));
        return step.isPossible() ? step.reaction() : new Reaction(Map.of(), before);
    }

    private static boolean isEnabled(Move move, Situation before, Optional<Boolean> a) {
        return move.below().map(number -> before.variables().get("n") < number).orElse(true)
                && move.input().map(asked -> fits(asked, a)).orElse(true);
    }

    private static boolean fits(String asked, Optional<Boolean> a) {
        return switch (asked) {
            case "--" -> a.isEmpty();
            case "?" -> a.isPresent();
            default -> a.map(String::valueOf).filter(asked::equals).isPresent();
        };
    }

    private Node node(String name) {
        return machine.root().all().stream()
                .filter(each -> each.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /** From the outermost state to this one. */
    private List<Node> path(String name) {
        List<Node> path = new ArrayList<>();
        for (Node each : machine.root().all()) {
            if (!each.name().isEmpty()
                    && each.all().stream().anyMatch(inner -> inner.name().equals(name))) {
                path.add(each);
            }
        }
        return path;
    }

    private final class Step {
        private final Map<String, String> last;
        private final Map<String, Integer> variables;
        private final Map<String, Integer> sent = new TreeMap<>();
        private final Optional<Boolean> a;

        /** What has its value, in the end, from a message that is not there. */
        private final Set<String> missing = new HashSet<>();

        private String active = "";

        Step(Map<String, String> last, Map<String, Integer> variables, Optional<Boolean> a) {
            this.a = a;
            this.last = new HashMap<>(last);
            this.variables = new HashMap<>(variables);
        }

        boolean isPossible() {
            return missing.isEmpty();
        }

        Reaction reaction() {
            return new Reaction(sent, new Situation(active, last, variables));
        }

        void take(Move move, String from) {
            active = from;
            if (move.target().isEmpty()) {
                move.writes().forEach(this::write);
                return;
            }
            List<Node> toLeave = path(from);
            List<Node> toEnter = path(move.target().get());
            List<Node> outside = new ArrayList<>(path(move.source()));
            outside.remove(outside.size() - 1);
            outside.retainAll(toEnter.subList(0, toEnter.size() - 1));
            toLeave.removeAll(outside);
            toEnter.removeAll(outside);
            Collections.reverse(toLeave);
            for (Node each : toLeave) {
                each.exit().forEach(this::write);
                last.put(each.name(), from);
            }
            move.writes().forEach(this::write);
            toEnter.forEach(each -> each.entry().forEach(this::write));
            Node goal = toEnter.get(toEnter.size() - 1);
            goOn(goal, move.memory());
        }

        /** In a state that was entered. */
        private void goOn(Node state, String memory) {
            if (memory.isEmpty() || !last.containsKey(state.name())) {
                begin(state);
                return;
            }
            List<Node> inner = path(last.get(state.name()));
            inner.removeAll(path(state.name()));
            if (memory.equals(".history")) {
                inner.get(0).entry().forEach(this::write);
                begin(inner.get(0));
            } else {
                inner.forEach(each -> each.entry().forEach(this::write));
                active = last.get(state.name());
            }
        }

        void begin(Node state) {
            active = state.name();
            if (!state.isSimple()) {
                state.beginning().forEach(this::write);
                Node first = node(state.first());
                first.entry().forEach(this::write);
                begin(first);
            }
        }

        private void write(Write write) {
            missing.remove(write.name());
            if (write.value().reads() == Reads.A && a.isEmpty()) {
                missing.add(write.name());
            }
            int value = value(write.value());
            if (variables.containsKey(write.name())) {
                variables.put(write.name(), value);
            } else if (sent.put(write.name(), value) != null) {
                throw new SentTwice();
            }
        }

        private int value(Value value) {
            return switch (value.reads()) {
                case NOTHING -> value.number();
                case N -> (variables.get("n") + value.number()) % 8;
                case A -> a.orElse(false) ? 1 : value.number();
            };
        }
    }
}

package arcomat.analysis;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Behaviour;
import arcomat.semantics.Configuration;
import arcomat.semantics.Fault;
import arcomat.semantics.Input;
import arcomat.semantics.Output;
import arcomat.semantics.Reaction;
import arcomat.semantics.Sent;
import arcomat.semantics.StepRelation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * The meaning of requirement sets, step by step and letter by letter, with all inputs and outputs
 * written out: slow, and without any code of the engine.
 */
final class Outcomes {
    /** What the requirements may be in; the run's end is an empty list of sets. */
    private record Position(List<Set<Configuration>> sets) {
        private static final Position END = new Position(List.of());
    }

    private final List<StepRelation> relations = new ArrayList<>();
    private List<Output> outputs;
    private final List<Value[]> inputs;
    private final Component component;

    Outcomes(List<Promise> requirements) {
        component = requirements.get(0).component();
        for (Promise each : requirements) {
            relations.addAll(
                    Behaviour.of(component, each.automata(), each.arguments()).relations());
        }
        outputs = new ArrayList<>(List.of(new Output(List.of())));
        for (Port port : component.outputs()) {
            List<Output> longer = new ArrayList<>();
            for (Output output : outputs) {
                for (Sent sent : sent(port)) {
                    List<Sent> ports = new ArrayList<>(output.ports());
                    ports.add(sent);
                    longer.add(new Output(ports));
                }
            }
            outputs = longer;
        }
        inputs =
                letters(component.inputs()).stream()
                        .filter(letter -> !isEventDriven() || events(letter) == 1)
                        .toList();
    }

    private boolean isEventDriven() {
        return component.profile() == Component.Profile.EVENT_DRIVEN;
    }

    private static long events(Value[] letter) {
        return java.util.Arrays.stream(letter).filter(Objects::nonNull).count();
    }

    /** In answer to an event, up to two messages. */
    private List<Sent> sent(Port port) {
        List<Sent> sent = new ArrayList<>();
        List<Value> values = values(port);
        for (Value one : values) {
            sent.add(sent(one));
            for (Value two : isEventDriven() && one != null ? values : List.<Value>of()) {
                if (two != null) {
                    sent.add(new Sent.Messages(List.of(one, two)));
                }
            }
        }
        return sent;
    }

    private static Sent sent(Value message) {
        return message == null ? Sent.SILENCE : new Sent.Messages(List.of(message));
    }

    /** All letters, messages by position. */
    static List<Value[]> letters(List<Port> ports) {
        List<Value[]> letters = new ArrayList<>();
        letters.add(new Value[ports.size()]);
        for (int port = 0; port < ports.size(); port++) {
            List<Value[]> longer = new ArrayList<>();
            for (Value[] letter : letters) {
                for (Value value : values(ports.get(port))) {
                    Value[] copy = letter.clone();
                    copy[port] = value;
                    longer.add(copy);
                }
            }
            letters = longer;
        }
        return letters;
    }

    private static List<Value> values(Port port) {
        List<Value> values = new ArrayList<>();
        if (!port.total() || !port.isInput() && port.delay() == 0) {
            values.add(null);
        }
        values.addAll(SomeValues.of(port.type()));
        return values;
    }

    /** Whether some outputs comply after a word. */
    boolean somethingComplies(List<Letter> word) {
        Set<Position> positions = new LinkedHashSet<>(openings());
        for (Letter letter : word) {
            Set<Position> next = new LinkedHashSet<>();
            for (Position position : positions) {
                Input input = Input.of(component, letter);
                next.addAll(answers(position, input));
            }
            positions = next;
        }
        return !positions.isEmpty();
    }

    /** Whether the environment can make every system break a requirement with so many inputs. */
    boolean isLost(int inputsLeft) {
        Map<Position, Map<Integer, Boolean>> known = new LinkedHashMap<>();
        for (Position opening : openings()) {
            if (!isLost(opening, inputsLeft, known)) {
                return false;
            }
        }
        return true;
    }

    private boolean isLost(
            Position position, int left, Map<Position, Map<Integer, Boolean>> known) {
        if (left == 0 || position.equals(Position.END)) {
            return false;
        }
        Map<Integer, Boolean> own = known.computeIfAbsent(position, p -> new LinkedHashMap<>());
        Boolean before = own.get(left);
        if (before == null) {
            before = false;
            for (Value[] letter : inputs) {
                Set<Position> answers = answers(position, Input.of(letter));
                before |= answers.stream().allMatch(each -> isLost(each, left - 1, known));
            }
            own.put(left, before);
        }
        return before;
    }

    private Set<Position> openings() {
        Set<Position> positions = new LinkedHashSet<>();
        for (Output output : outputs) {
            List<Set<Configuration>> sets = new ArrayList<>();
            for (StepRelation relation : relations) {
                Set<Configuration> set = new LinkedHashSet<>();
                relation.starts().stream()
                        .filter(start -> start.output().meet(output).isPresent())
                        .forEach(start -> set.add(start.configuration()));
                sets.add(set);
            }
            if (sets.stream().noneMatch(Set::isEmpty)) {
                positions.add(new Position(sets));
            }
        }
        return positions;
    }

    private Set<Position> answers(Position position, Input input) {
        Set<Position> answers = new LinkedHashSet<>();
        if (position.equals(Position.END)) {
            return Set.of(Position.END);
        }
        for (Output output : outputs) {
            List<Set<Configuration>> sets = new ArrayList<>();
            for (int i = 0; i < relations.size(); i++) {
                sets.add(after(relations.get(i), position.sets().get(i), input, output));
            }
            if (sets.stream().noneMatch(Set::isEmpty)) {
                answers.add(new Position(sets));
            }
        }
        boolean ends = true;
        for (int i = 0; i < relations.size(); i++) {
            ends &= mayEnd(relations.get(i), position.sets().get(i), input);
        }
        if (ends) {
            answers.add(Position.END);
        }
        return answers;
    }

    private static List<Reaction> reactions(
            StepRelation relation, Configuration before, Input input) {
        try {
            return relation.reactions(before, input);
        } catch (Fault fault) {
            return List.of();
        }
    }

    private static Set<Configuration> after(
            StepRelation relation, Set<Configuration> before, Input input, Output output) {
        Set<Configuration> after = new LinkedHashSet<>();
        for (Configuration each : before) {
            for (Reaction reaction : reactions(relation, each, input)) {
                if (reaction.next() != Configuration.ERROR
                        && reaction.output().meet(output).isPresent()) {
                    after.add(reaction.next());
                }
            }
        }
        return after;
    }

    /** In the distinguished error, or in a fault. */
    private static boolean mayEnd(StepRelation relation, Set<Configuration> before, Input input) {
        for (Configuration each : before) {
            List<Reaction> reactions = reactions(relation, each, input);
            if (reactions.isEmpty()
                    || reactions.stream().anyMatch(r -> r.next() == Configuration.ERROR)) {
                return true;
            }
        }
        return false;
    }
}

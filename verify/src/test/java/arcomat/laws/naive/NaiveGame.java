package arcomat.laws.naive;

import arcomat.laws.naive.NaiveAutomata.Place;
import arcomat.laws.naive.NaiveAutomata.Step;
import arcomat.laws.naive.NaiveAutomata.Steps;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Whether some automata can be kept together: the surroundings choose an input, the system an
 * output that each of the automata allows, or an error where each may err.
 */
public final class NaiveGame {
    /** Per automaton all places in which it may be; nothing after an error. */
    private record Position(List<Set<Place>> places) {
        static final Position END = new Position(List.of());
    }

    private final List<NaiveAutomata> each = new ArrayList<>();
    private final List<Map<String, Value>> inputs;
    private final List<Map<String, Value>> outputs;

    /**
     * @param automata of the component, those that are to be kept
     */
    public NaiveGame(Component component, List<Automaton> automata) {
        automata.forEach(a -> each.add(new NaiveAutomata(component, List.of(a))));
        inputs = NaiveQuestion.letters(component, component, List.of());
        outputs = letters(component.outputs());
    }

    /** Whether all types are small, in slices. */
    public static boolean isPlayed(Component component) {
        return component.profile() == Component.Profile.TIME_SYNCHRONOUS
                && component.ports().stream().allMatch(p -> NaiveValues.isSmall(p.type()));
    }

    private static List<Map<String, Value>> letters(List<Port> ports) {
        List<Map<String, Value>> letters = List.of(Map.of());
        for (Port port : ports) {
            List<Map<String, Value>> longer = new ArrayList<>();
            for (Map<String, Value> letter : letters) {
                for (Slot slot : Slot.open(port).writtenOut(port, List.of())) {
                    Map<String, Value> copy = new HashMap<>(letter);
                    copy.put(port.name(), slot.message());
                    longer.add(copy);
                }
            }
            letters = longer;
        }
        return letters;
    }

    /** Whether the surroundings win with so many inputs. */
    public boolean isLost(int mostInputs) {
        Map<Integer, Map<Position, Boolean>> known = new HashMap<>();
        return starts().stream().allMatch(start -> isLost(start, mostInputs, known));
    }

    private boolean isLost(
            Position position, int left, Map<Integer, Map<Position, Boolean>> known) {
        if (left == 0 || position.equals(Position.END)) {
            return false;
        }
        Map<Position, Boolean> own = known.computeIfAbsent(left, key -> new HashMap<>());
        Boolean lost = own.get(position);
        if (lost == null) {
            lost =
                    inputs.stream()
                            .anyMatch(
                                    input ->
                                            answers(position, input).stream()
                                                    .allMatch(p -> isLost(p, left - 1, known)));
            own.put(position, lost);
        }
        return lost;
    }

    /** Whether some outputs comply with all inputs of a word. */
    public boolean isAnswered(List<Letter> word) {
        Set<Position> positions = starts();
        for (Letter letter : word) {
            Map<String, Value> input = new HashMap<>();
            letter.messages().forEach((port, messages) -> input.put(port, messages.get(0)));
            Set<Position> next = new HashSet<>();
            positions.forEach(position -> next.addAll(answers(position, input)));
            positions = next;
        }
        return !positions.isEmpty();
    }

    private Set<Position> starts() {
        Set<Position> positions = new HashSet<>();
        for (Map<String, Value> output : outputs) {
            List<Set<Place>> places = new ArrayList<>();
            each.forEach(a -> places.add(agreeing(a, a.starts(), output, true)));
            add(places, positions);
        }
        return positions;
    }

    private Set<Position> answers(Position position, Map<String, Value> input) {
        if (position.equals(Position.END)) {
            return Set.of(Position.END);
        }
        List<List<Step>> steps = new ArrayList<>();
        boolean ends = true;
        for (int i = 0; i < each.size(); i++) {
            List<Step> own = new ArrayList<>();
            boolean error = false;
            for (Place place : position.places.get(i)) {
                Steps found = each.get(i).steps(List.of(place), input, false);
                own.addAll(found.steps());
                error |= found.error();
            }
            steps.add(own);
            ends &= error;
        }
        Set<Position> answers = new HashSet<>();
        if (ends) {
            answers.add(Position.END);
        }
        for (Map<String, Value> output : outputs) {
            List<Set<Place>> places = new ArrayList<>();
            for (int i = 0; i < each.size(); i++) {
                places.add(agreeing(each.get(i), steps.get(i), output, false));
            }
            add(places, answers);
        }
        return answers;
    }

    private static void add(List<Set<Place>> places, Set<Position> positions) {
        if (places.stream().noneMatch(Set::isEmpty)) {
            positions.add(new Position(places));
        }
    }

    /** Without a delay nothing is sent at the start. */
    private static Set<Place> agreeing(
            NaiveAutomata automata, List<Step> steps, Map<String, Value> output, boolean start) {
        Set<Place> places = new HashSet<>();
        for (Step step : steps) {
            boolean same =
                    automata.component().outputs().stream()
                            .filter(port -> !start || port.delay() == 1)
                            .allMatch(
                                    port ->
                                            step.outputs()
                                                    .get(port.name())
                                                    .allows(
                                                            Slot.of(output.get(port.name()))
                                                                    .messages()));
            if (same) {
                places.add(step.places().get(0));
            }
        }
        return places;
    }
}

package arcomat.laws.naive;

import arcomat.laws.naive.NaiveBehaviour.Move;
import arcomat.laws.naive.NaiveBehaviour.Moves;
import arcomat.laws.naive.NaiveBehaviour.State;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What a component may show for a word of inputs, slice by slice: all words of outputs, written
 * out. Silence is null.
 */
public final class NaiveWords {
    private static final int MOST_WORDS = 3_000;

    /** It is not to be told by words: there is an error, no step, or too much. */
    public static final class NoWords extends RuntimeException {
        private static final long serialVersionUID = 1L;
    }

    private final Component component;
    private final NaiveBehaviour behaviour;
    private final Map<List<Map<String, Value>>, Set<List<Map<String, Value>>>> known =
            new HashMap<>();

    public NaiveWords(Component component) {
        this.component = component;
        this.behaviour = NaiveBehaviour.of(component, component.automata(), List.of(), true);
    }

    /** A run, by where it is and what it has shown. */
    private record Run(State state, List<Map<String, Value>> shown) {}

    /** All words of one length over the inputs of a component, or of some of them. */
    public static List<List<Map<String, Value>>> inputs(Component component, int length) {
        List<Map<String, Value>> letters = NaiveQuestion.letters(component, component, List.of());
        List<List<Map<String, Value>>> words = List.of(List.of());
        for (int i = 0; i < length; i++) {
            List<List<Map<String, Value>>> longer = new ArrayList<>();
            for (List<Map<String, Value>> word : words) {
                letters.forEach(letter -> longer.add(plus(word, letter)));
            }
            words = longer;
        }
        return words;
    }

    /** What it may show for a word; of letters with further ports only its own count. */
    public Set<List<Map<String, Value>>> answers(List<Map<String, Value>> word) {
        return known.computeIfAbsent(word.stream().map(this::own).toList(), this::tried);
    }

    private Map<String, Value> own(Map<String, Value> letter) {
        Map<String, Value> own = new HashMap<>();
        component.inputs().forEach(port -> own.put(port.name(), letter.get(port.name())));
        return own;
    }

    private Set<List<Map<String, Value>>> tried(List<Map<String, Value>> word) {
        Set<Run> runs = new HashSet<>();
        certain(behaviour.starts()).forEach(each -> runs.add(new Run(each.next(), List.of())));
        Set<Run> now = runs;
        for (Map<String, Value> letter : word) {
            Set<Run> next = new HashSet<>();
            for (Run run : now) {
                for (Move move : certain(behaviour.moves(run.state, letter))) {
                    next.add(new Run(move.next(), plus(run.shown, shown(run.state, move))));
                }
            }
            if (next.size() > MOST_WORDS) {
                throw new NoWords();
            }
            now = next;
        }
        Set<List<Map<String, Value>>> words = new HashSet<>();
        now.forEach(run -> words.add(run.shown));
        return words;
    }

    private static Set<Move> certain(Moves moves) {
        if (moves.error() || moves.moves().isEmpty()) {
            throw new NoWords();
        }
        return moves.moves();
    }

    private Map<String, Value> shown(State before, Move move) {
        Map<String, Value> shown = new HashMap<>();
        for (Port port : component.outputs()) {
            String name = port.name();
            Slot slot =
                    behaviour.isLate(name) ? behaviour.due(before, name) : move.outputs().get(name);
            shown.put(name, slot.message());
        }
        return shown;
    }

    private static <T> List<T> plus(List<T> list, T last) {
        List<T> longer = new ArrayList<>(list);
        longer.add(last);
        return longer;
    }
}

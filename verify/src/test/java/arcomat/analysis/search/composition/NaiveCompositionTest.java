package arcomat.analysis.search.composition;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Draft;
import arcomat.analysis.NaiveComposition;
import arcomat.analysis.NaiveComposition.Move;
import arcomat.analysis.NaiveComposition.State;
import arcomat.analysis.NaiveInclusion;
import arcomat.analysis.NaiveMachine;
import arcomat.analysis.RandomNetworks;
import arcomat.analysis.Script;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.simulate.run.Interpreter;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;

/**
 * What naive enumeration says a composition can do is what the interpreter shows when it decides
 * every open question in every way. Without chaos, which an interpreter does not leave its state
 * for.
 */
class NaiveCompositionTest {
    private static final int LENGTH = 3;
    private static final int MOST_RUNS = 400;

    @Tag("slow")
    @Test
    void doesWhatTheInterpreterDoes() {
        RandomNetworks compositions = new RandomNetworks(51);
        Random random = new Random(52);
        int compared = 0;
        int open = 0;
        for (int i = 0; i < 60; i++) {
            Component whole = withoutChaos(compositions.plan()).component("Whole");
            List<Map<String, Value>> word = word(whole, random);
            Optional<Set<List<Map<String, Value>>>> shown = interpreted(whole, word);
            if (shown.isPresent()) {
                assertThat(naive(whole, word)).as("composition %d", i).isEqualTo(shown.get());
                compared++;
                open += shown.get().size() > 1 ? 1 : 0;
            }
        }
        assertThat(compared).as("compared").isGreaterThan(30);
        assertThat(open).as("more than one run is possible").isGreaterThan(12);
    }

    private static RandomNetworks.Plan withoutChaos(RandomNetworks.Plan plan) {
        RandomNetworks.Plan changed = plan;
        for (int i = 0; i < plan.parts().size(); i++) {
            Draft part = plan.parts().get(i);
            if (part.completion() == Completion.CHAOS) {
                changed = changed.withPart(i, part.with(Completion.OUTPUT));
            }
        }
        return changed;
    }

    private static List<Map<String, Value>> word(Component whole, Random random) {
        List<Map<String, Value>> letters = NaiveInclusion.letters(whole.inputs());
        List<Map<String, Value>> word = new ArrayList<>();
        while (word.size() < LENGTH) {
            word.add(letters.get(random.nextInt(letters.size())));
        }
        return word;
    }

    /** What is visible slice by slice; what a delay keeps for the slice behind the last is not. */
    private static Set<List<Map<String, Value>>> naive(
            Component whole, List<Map<String, Value>> word) {
        NaiveComposition composition = new NaiveComposition(whole, List.of());
        Set<List<Map<String, Value>>> found = new HashSet<>();
        for (Move start : composition.starts()) {
            extend(composition, start, word, List.of(), found);
        }
        return found;
    }

    private static void extend(
            NaiveComposition composition,
            Move before,
            List<Map<String, Value>> word,
            List<Map<String, Value>> shown,
            Set<List<Map<String, Value>>> found) {
        if (shown.size() == word.size()) {
            found.add(shown);
            return;
        }
        State state = before.next();
        for (Move move : composition.moves(state, word.get(shown.size()))) {
            List<Map<String, Value>> longer = new ArrayList<>(shown);
            if (move.output() == NaiveMachine.ERROR) {
                longer.add(NaiveMachine.ERROR);
                found.add(longer);
                continue;
            }
            Map<String, Value> slice = new LinkedHashMap<>();
            for (Port port : composition.component().outputs()) {
                Move seen = composition.isDelayed(port.name()) ? before : move;
                slice.put(port.name(), seen.output().get(port.name()));
            }
            longer.add(slice);
            extend(composition, move, word, longer, found);
        }
    }

    /** All runs over a word; empty if there are too many. */
    private static Optional<Set<List<Map<String, Value>>>> interpreted(
            Component whole, List<Map<String, Value>> word) {
        Set<List<Map<String, Value>>> found = new HashSet<>();
        Script script = new Script(Integer.MAX_VALUE);
        for (int runs = 0; runs < MOST_RUNS; runs++) {
            found.add(run(new Interpreter(whole, List.of(), script), whole, word));
            if (!script.advance()) {
                return Optional.of(found);
            }
        }
        return Optional.empty();
    }

    private static List<Map<String, Value>> run(
            Interpreter interpreter, Component whole, List<Map<String, Value>> word) {
        List<Map<String, Value>> shown = new ArrayList<>();
        for (Map<String, Value> letter : word) {
            Map<String, Value> messages = new LinkedHashMap<>(letter);
            messages.values().removeIf(value -> value == null);
            try {
                Letter outputs = interpreter.step(Letter.of(messages)).outputs();
                Map<String, Value> slice = new LinkedHashMap<>();
                for (Port port : whole.outputs()) {
                    slice.put(port.name(), outputs.message(port.name()).orElse(null));
                }
                shown.add(slice);
            } catch (ModelError forbidden) {
                shown.add(NaiveMachine.ERROR);
                return shown;
            }
        }
        return shown;
    }
}

package arcomat.analysis;

import arcomat.analysis.engine.SmallType;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.simulate.Choice;
import arcomat.simulate.Interpreter;
import arcomat.simulate.Question;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * All runs of an event-driven component by the simulator: every sequence of choices, one run each.
 * Of a port that is left open, silence and each single message.
 */
final class SimulatedRuns {
    /** So many choices in one run are taken for a circle. */
    private static final int MOST_CHOICES = 60;

    /**
     * What the surroundings see.
     *
     * @param outputs per step and port
     * @param error whether the run ends with an error after these steps
     */
    record Run(List<Map<String, List<Value>>> outputs, boolean error) {}

    private SimulatedRuns() {}

    /** The first step is the beginning, without an event. */
    static Set<Run> of(Component component, List<Value> arguments, List<Letter> letters) {
        Script script = new Script();
        Set<Run> runs = new LinkedHashSet<>();
        do {
            runs.add(run(new Interpreter(component, arguments, script), letters));
        } while (script.advance());
        return runs;
    }

    private static Run run(Interpreter interpreter, List<Letter> letters) {
        List<Map<String, List<Value>>> outputs = new ArrayList<>();
        try {
            outputs.add(interpreter.step(Letter.SILENCE).outputs().messages());
            for (Letter letter : letters) {
                outputs.add(interpreter.step(letter).outputs().messages());
            }
        } catch (ModelError error) {
            return new Run(outputs, true);
        }
        return new Run(outputs, false);
    }

    /** Follows a script, the first alternative after its end. */
    private static final class Script implements Choice {
        private final List<Integer> picks = new ArrayList<>();
        private final List<Integer> counts = new ArrayList<>();
        private int position;

        @Override
        public int pick(Question question) {
            return pick(question.count());
        }

        private int pick(int count) {
            if (position == MOST_CHOICES) {
                throw new ModelError("messages circle");
            }
            if (position == picks.size()) {
                picks.add(0);
                counts.add(count);
            }
            return picks.get(position++);
        }

        @Override
        public Optional<Value> message(Port port, boolean required) {
            List<Value> values = SmallType.values(port.type()).orElseThrow();
            int picked = pick(values.size() + (required ? 0 : 1));
            return picked == values.size() ? Optional.empty() : Optional.of(values.get(picked));
        }

        boolean advance() {
            position = 0;
            while (!picks.isEmpty()) {
                int last = picks.size() - 1;
                if (picks.get(last) + 1 < counts.get(last)) {
                    picks.set(last, picks.get(last) + 1);
                    return true;
                }
                picks.remove(last);
                counts.remove(last);
            }
            return false;
        }
    }
}

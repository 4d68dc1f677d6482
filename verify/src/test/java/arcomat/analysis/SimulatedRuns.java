package arcomat.analysis;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.simulate.run.Interpreter;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * All runs of an event-driven component by the simulator: every sequence of choices, one run each.
 * Of a port that is left open, silence and each single message.
 */
public final class SimulatedRuns {
    /** So many choices in one run are taken for a circle. */
    private static final int MOST_CHOICES = 60;

    /**
     * What the surroundings see.
     *
     * @param outputs per step and port
     * @param error whether the run ends with an error after these steps
     */
    public record Run(List<Map<String, List<Value>>> outputs, boolean error) {}

    private SimulatedRuns() {}

    /** The first step is the beginning, without an event. */
    public static Set<Run> of(Component component, List<Value> arguments, List<Letter> letters) {
        Script script = new Script(MOST_CHOICES);
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
}

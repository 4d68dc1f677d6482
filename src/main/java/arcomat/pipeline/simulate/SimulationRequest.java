package arcomat.pipeline.simulate;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * A run that is asked for.
 *
 * @param main the component, {@code p.Timer(2)} with its arguments; empty if the input or the
 *     models leave only one
 * @param slices how many steps to run; empty for the length of the input
 * @param seed of whatever is drawn: choices, and letters where there is no input
 * @param input {@code FILE.mt#test}, whose input streams are used
 * @param record a file that keeps the run as a stream test
 * @param monitors what watches the run: components, or {@code component#automaton}
 * @param whole whether the result holds all steps, though there is an audience
 */
public record SimulationRequest(
        Optional<String> main,
        OptionalInt slices,
        int seed,
        Choosing choosing,
        Engine engine,
        Optional<String> input,
        Optional<String> record,
        List<String> monitors,
        boolean whole) {
    public SimulationRequest {
        monitors = List.copyOf(monitors);
    }

    /** Whether all steps are needed at once. */
    boolean keepsSteps() {
        return whole || record.isPresent();
    }

    /** Who decides where a model leaves something open. */
    public enum Choosing {
        /** The first alternative in text order. */
        FIRST,
        RANDOM,
        /** Somebody at a terminal. */
        ASK
    }

    /** What runs the model. */
    public enum Engine {
        INTERPRETER,
        COMPILED
    }
}

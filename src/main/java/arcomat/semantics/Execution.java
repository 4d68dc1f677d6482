package arcomat.semantics;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.rt.ModelError;

import java.util.Optional;

/**
 * One run of one component, interpreted or compiled. It starts initialised: the first step is slice
 * 0 and shows the initial outputs where outputs have delay 1.
 */
public interface Execution {
    /** After so many reactions to one event, messages are taken to circle for ever. */
    int MOST_REACTIONS = 100_000;

    /** What such a run ends with. */
    static ModelError circling() {
        return new ModelError(
                "messages circle without end: "
                        + MOST_REACTIONS
                        + " reactions to one event, and still some wait");
    }

    Component component();

    /**
     * Performs one slice or one event.
     *
     * @param input messages on the component's input ports and, by instance path ({@code
     *     fetcher.left.value}), on the output ports of platform components inside it
     * @return what was visible, external outputs and the inputs of platform components included
     * @throws arcomat.rt.ModelError where the model itself goes wrong: range, division by zero,
     *     absent total port, queue overflow, error completion
     */
    Trace.Step step(Letter input);

    /** See {@link Trace#opening}. */
    Optional<Letter> opening();

    /** See {@link Trace#end}; of the step that has just failed. */
    Optional<Trace.End> end();
}

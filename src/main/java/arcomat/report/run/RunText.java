package arcomat.report.run;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;

/** A run as a text that grows while it goes on, so that no more of it is kept than is needed. */
public interface RunText {
    /** What stands before all steps. */
    void begin(Component component, TraceColumns columns);

    void step(Trace.Step step);

    /**
     * What stands behind the steps.
     *
     * @param steps how many have been shown
     * @param rest what there is to say of the run besides its steps
     */
    void end(int steps, Trace rest);

    /** Says nothing. */
    RunText NOTHING =
            new RunText() {
                @Override
                public void begin(Component component, TraceColumns columns) {}

                @Override
                public void step(Trace.Step step) {}

                @Override
                public void end(int steps, Trace rest) {}
            };

    /** Whether a step went wrong of which there is something to be seen. */
    static boolean endsInError(Trace rest) {
        return !rest.shown().isEmpty();
    }

    /** What came in with the step that went wrong. */
    static Letter lastInputs(Trace rest) {
        return rest.received().get(0);
    }

    /** What was to be seen in the step that went wrong. */
    static Letter lastOutputs(Trace rest) {
        return rest.shown().get(0);
    }
}

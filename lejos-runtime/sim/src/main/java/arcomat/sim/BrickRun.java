package arcomat.sim;

import arcomat.sim.load.Program;
import arcomat.sim.script.Script;
import arcomat.sim.trace.Recorder;
import arcomat.sim.trace.Trace;

import java.util.List;

/**
 * A whole run of one brick.
 *
 * @param trace what the program did
 * @param outcome how it ended; {@link Outcome.Kind#RUNNING} if the time was up before
 * @param milliseconds when the run was over
 * @param screen the rows of the screen at the end
 */
public record BrickRun(Trace trace, Outcome outcome, long milliseconds, List<String> screen) {
    public BrickRun {
        screen = List.copyOf(screen);
    }

    /**
     * Runs a program until it ends, the script ends it, or the time is up.
     *
     * @param name the brick's name
     * @param limit in milliseconds
     */
    public static BrickRun of(String name, Program program, Script script, long limit) {
        Recorder recorder = new Recorder();
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = laboratory.place(name, program);
            brick.observe(recorder);
            brick.play(script);
            laboratory.runToEnd(limit);
            return new BrickRun(
                    recorder.trace(), brick.outcome(), laboratory.time(), brick.screen());
        }
    }
}

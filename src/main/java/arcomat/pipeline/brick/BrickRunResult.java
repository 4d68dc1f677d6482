package arcomat.pipeline.brick;

import arcomat.sim.trace.Lateness;
import arcomat.sim.trace.Recorder.Misfit;
import arcomat.sim.trace.Trace;
import arcomat.source.Diagnostic;

import java.util.List;
import java.util.Optional;

/**
 * What came of running a program on a simulated brick.
 *
 * @param findings about the program, or about the script
 * @param run empty exactly if the findings did not let the program run
 */
public record BrickRunResult(List<Diagnostic> findings, Optional<Run> run) {
    public BrickRunResult {
        findings = List.copyOf(findings);
    }

    /**
     * A run.
     *
     * @param milliseconds of virtual time
     * @param ending how it ended, in words: "the program ended"
     * @param failure what nothing in the program caught
     * @param misfits what the script exposes sensors to, and they cannot sense
     * @param lateness how often the program came late
     * @param screen what the display shows at the end, without empty rows at its end
     */
    public record Run(
            Trace trace,
            long milliseconds,
            String ending,
            Optional<String> failure,
            List<Misfit> misfits,
            Lateness lateness,
            List<String> screen) {}
}

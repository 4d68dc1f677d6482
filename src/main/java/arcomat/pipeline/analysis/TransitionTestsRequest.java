package arcomat.pipeline.analysis;

/**
 * Stream tests that are to take every transition.
 *
 * @param component as written: {@code p.Timer(2)}, or {@code p.Robot#waits} for the transitions of
 *     one automaton
 * @param out the folder to write, which is replaced as a whole
 */
public record TransitionTestsRequest(String component, String out, AnalysisLimits limits) {}

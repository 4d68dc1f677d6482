package arcomat.pipeline.analysis;

import java.util.Optional;

/**
 * Whether the requirements on a component contradict each other.
 *
 * @param component as written: {@code p.Timer(2)}, or {@code p.Robot#waits} for one automaton only
 * @param all whether all minimal contradicting subsets are wanted
 * @param out the folder for a controller, which is replaced as a whole
 */
public record ContradictionsRequest(
        String component, boolean all, Optional<String> out, AnalysisLimits limits) {}

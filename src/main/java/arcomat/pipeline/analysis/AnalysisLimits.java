package arcomat.pipeline.analysis;

import arcomat.analysis.Budget;

import java.util.Optional;

/**
 * How long an analysis may take before its answer is unknown.
 *
 * @param seconds from the moment when it starts; without end if empty
 * @param states the most configurations, or pairs of them; as many as the heap holds if empty
 */
public record AnalysisLimits(Optional<Integer> seconds, Optional<Long> states) {

    /** A budget that runs from now on. */
    public Budget budget() {
        Lookout lookout = Lookout.post(seconds);
        return new Budget(lookout::isLate, lookout::isFull, states.orElseGet(Budget::statesOfHeap));
    }
}

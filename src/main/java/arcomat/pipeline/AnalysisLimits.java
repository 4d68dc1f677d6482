package arcomat.pipeline;

import arcomat.analysis.Budget;

import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * How long an analysis may take before its answer is unknown.
 *
 * @param seconds from the moment when it starts; without end if empty
 * @param states the most configurations, or pairs of them; as many as the heap holds if empty
 */
public record AnalysisLimits(Optional<Integer> seconds, Optional<Long> states) {

    /** A budget that runs from now on. */
    Budget budget() {
        Budget all = Budget.ofMemory();
        long start = System.nanoTime();
        long patience = seconds.map(TimeUnit.SECONDS::toNanos).orElse(Long.MAX_VALUE);
        return new Budget(() -> System.nanoTime() - start > patience, states.orElse(all.states()));
    }
}

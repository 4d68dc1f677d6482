package arcomat.pipeline.analysis;

import arcomat.analysis.search.Budget;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * How long an analysis may take before its answer is unknown.
 *
 * @param time without end if empty
 * @param states the most configurations, or pairs of them; as many as the heap holds if empty
 * @param begun when the time began, as {@link System#nanoTime} tells it; with each budget if empty
 */
public record AnalysisLimits(Optional<Duration> time, Optional<Long> states, Optional<Long> begun) {

    /** Limits of each budget alone. */
    public AnalysisLimits(Optional<Duration> time, Optional<Long> states) {
        this(time, states, Optional.empty());
    }

    /** The same for each budget alone. */
    public AnalysisLimits each() {
        return new AnalysisLimits(time, states);
    }

    /** When the time ends that began at a moment. */
    public Optional<Long> end(long beginning) {
        return time.map(length -> beginning + length.toNanos());
    }

    /** For another program; it gets a second at least. */
    public Optional<Integer> secondsLeft() {
        long now = System.nanoTime();
        return end(begun.orElse(now))
                .map(end -> (int) Math.max(1, 1 + TimeUnit.NANOSECONDS.toSeconds(end - now - 1)));
    }

    /** How much may be explored until then. */
    public Budget budget() {
        return budget(states.orElseGet(Budget::statesOfHeap));
    }

    /** As above, where states need not be in memory. */
    Budget beyondMemory() {
        return budget(states.orElse(Long.MAX_VALUE));
    }

    private Budget budget(long most) {
        Lookout lookout = Lookout.post(end(begun.orElseGet(System::nanoTime)));
        return new Budget(lookout::isLate, lookout::isFull, most);
    }
}

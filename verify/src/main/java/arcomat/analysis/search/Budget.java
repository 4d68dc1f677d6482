package arcomat.analysis.search;

import arcomat.semantics.value.GivenUp;

import org.jspecify.annotations.Nullable;

import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;

/**
 * How much may be explored before the answer is unknown, and what may be left out. Searches ask
 * before each state; long steps ask on the way, so that no single one outlasts the time by much.
 *
 * @param timeIsUp asked very often
 * @param memoryIsFull asked very often; there is still enough left to end with an answer
 * @param states the most configurations, or pairs of them
 * @param shortcuts whether a shortcut may be taken, asked each time
 */
public record Budget(
        BooleanSupplier timeIsUp,
        BooleanSupplier memoryIsFull,
        long states,
        Predicate<Shortcut> shortcuts) {
    static final String TIME = "the time is up";
    static final String MEMORY = "memory is full";

    /** Bytes of heap that one state is assumed to take. */
    private static final long PER_STATE = 400;

    private static final long FEW_STATES = 100_000;

    /** With all shortcuts. */
    public Budget(BooleanSupplier timeIsUp, BooleanSupplier memoryIsFull, long states) {
        this(timeIsUp, memoryIsFull, states, each -> true);
    }

    /** Without an eye on memory. */
    public Budget(BooleanSupplier timeIsUp, long states) {
        this(timeIsUp, () -> false, states);
    }

    /** No limit but the memory that there is. */
    public static Budget ofMemory() {
        return new Budget(() -> false, statesOfHeap());
    }

    /** As many states as the heap can be expected to hold. */
    public static long statesOfHeap() {
        return Math.max(FEW_STATES, Runtime.getRuntime().maxMemory() / PER_STATE);
    }

    /** The same time and memory for fewer states. */
    public Budget atMost(long fewer) {
        return new Budget(timeIsUp, memoryIsFull, Math.min(states, fewer), shortcuts);
    }

    /**
     * The same limits, and an end from outside.
     *
     * @param ended asked very often
     */
    public Budget endingWhen(BooleanSupplier ended) {
        return new Budget(
                () -> ended.getAsBoolean() || timeIsUp.getAsBoolean(),
                memoryIsFull,
                states,
                shortcuts);
    }

    /** The same with those shortcuts that may be taken. */
    public Budget with(Predicate<Shortcut> allowed) {
        return new Budget(timeIsUp, memoryIsFull, states, allowed);
    }

    /** Whether to leave work out now; to be asked when there is some that could be. */
    public boolean takes(Shortcut shortcut) {
        return shortcuts.test(shortcut);
    }

    /** The same until it has been asked so many times: a bound that is equal on every machine. */
    public Budget patient(long times) {
        long[] asked = {0};
        return new Budget(
                () -> ++asked[0] > times || timeIsUp.getAsBoolean(),
                memoryIsFull,
                states,
                shortcuts);
    }

    /** Why to stop now, or null. */
    public @Nullable String exhausted(long explored) {
        return explored > states ? "more than " + states + " states" : spent();
    }

    private @Nullable String spent() {
        return timeIsUp.getAsBoolean() ? TIME : memoryIsFull.getAsBoolean() ? MEMORY : null;
    }

    /** Whether time or memory is used up. */
    public boolean isSpent() {
        return spent() != null;
    }

    /**
     * In the middle of a long step.
     *
     * @throws GivenUp where time or memory is used up
     */
    public void insist() {
        String reason = spent();
        if (reason != null) {
            throw new GivenUp(reason);
        }
    }

    /**
     * The result of a search that may be given up, or for which memory may not suffice.
     *
     * @param unknown says the reason instead
     */
    public static <T> T within(Supplier<T> search, Function<String, T> unknown) {
        try {
            return search.get();
        } catch (GivenUp stopped) {
            return unknown.apply(stopped.getMessage());
        } catch (OutOfMemoryError full) {
            return unknown.apply(MEMORY);
        }
    }
}

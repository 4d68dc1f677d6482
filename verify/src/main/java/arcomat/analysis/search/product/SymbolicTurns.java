package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.encoding.SymbolicInclusion;
import arcomat.analysis.symbolic.PropertyDirectedReachability.Progress;

import org.jspecify.annotations.Nullable;

import java.util.Optional;
import java.util.function.Supplier;

/**
 * A second engine beside a search that has met many pairs: both take turns, counted in work and not
 * in time, so that on every machine the same one is first.
 */
final class SymbolicTurns {
    /** So many pairs are searched alone, in some 0.2 s: what ends so soon is told in full. */
    private static final long FIRST = 50_000;

    /** So many more between two turns. */
    private static final long BETWEEN = 5_000;

    /** Assignments of the solver for each pair, which take about as long. */
    private static final long WORK_FOR_A_PAIR = 2;

    /** Once the search has met as many pairs as it may, so many times its work, alone. */
    private static final long ALONE = 4;

    private final Supplier<Optional<SymbolicInclusion>> made;
    private final Budget budget;
    private @Nullable SymbolicInclusion engine;
    private Progress progress = Progress.WORKS;
    private long before;
    private long next = FIRST;

    /**
     * @param made makes the engine; empty where the question is none for it
     */
    SymbolicTurns(Supplier<Optional<SymbolicInclusion>> made, Budget budget) {
        this.made = made;
        this.budget = budget;
    }

    /** Lets the engine have its turn, if it is due; whether it has proved that nothing fails. */
    boolean prove(long pairs) {
        if (pairs < next) {
            return false;
        }
        next = pairs + BETWEEN;
        long due = pairs - before;
        before = pairs;
        return work(due * WORK_FOR_A_PAIR);
    }

    /** The search has ended undone: the engine goes on for a while. */
    boolean proveAlone(long pairs) {
        return pairs >= FIRST && work(pairs * WORK_FOR_A_PAIR * ALONE);
    }

    private boolean work(long amount) {
        if (engine == null && progress == Progress.WORKS) {
            engine = budget.takes(Shortcut.SYMBOLIC) ? made.get().orElse(null) : null;
            progress = engine == null ? Progress.HOPELESS : Progress.WORKS;
        }
        if (engine != null && progress == Progress.WORKS) {
            progress = engine.work(amount);
        }
        return progress == Progress.PROVED;
    }

    /** The engine, with an invariant that was found and checked; empty where none was. */
    Optional<SymbolicInclusion> proved() {
        return Optional.ofNullable(engine).filter(each -> progress == Progress.PROVED);
    }
}

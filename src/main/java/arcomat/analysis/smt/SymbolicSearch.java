package arcomat.analysis.smt;

import arcomat.analysis.smt.Reachability.Reachable;
import arcomat.analysis.smt.Reachability.Run;
import arcomat.analysis.smt.Reachability.Unknown;
import arcomat.analysis.smt.Reachability.Unreachable;
import arcomat.analysis.smt.Unrolling.StatePredicate;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.BooleanSupplier;

/**
 * Answers questions about runs of any length. For k = 0, 1, 2, ..: is there a run of k letters that
 * shows it (bounded model checking: Biere, Cimatti, Clarke, Zhu 1999)? If not: after k
 * configurations, wherever they come from, that do not show it, can the next one show it? If not
 * either, none ever does (k-induction: Sheeran, Singh, Stålmarck 2000). What is known to be
 * impossible helps with the rest, as do {@link Bounds} that nobody asked for.
 */
public final class SymbolicSearch {
    /** Longer runs are not looked for. */
    static final int LONGEST = 12;

    private final BiPredicate<RunProperty, Run> confirmed;
    private final BooleanSupplier stop;
    private final Unrolling fromStart;
    private final Unrolling fromAnywhere;
    private final Set<StatePredicate> bounds;
    private final Set<RunProperty> open;
    private final Set<RunProperty> doubtful = new LinkedHashSet<>();
    private final Map<RunProperty, Reachability> answers = new LinkedHashMap<>();

    private SymbolicSearch(
            Subject subject,
            Collection<RunProperty> asked,
            BiPredicate<RunProperty, Run> confirmed,
            BooleanSupplier stop) {
        this.confirmed = confirmed;
        this.stop = stop;
        this.fromStart = new Unrolling(subject, true, stop);
        this.fromAnywhere = new Unrolling(subject, false, stop);
        this.bounds = Bounds.candidates(subject);
        this.open = new LinkedHashSet<>(asked);
    }

    /**
     * @param confirmed whether the automaton itself agrees with a run that was found
     * @param stop asked now and then; what is open then stays open
     * @return for each property what is known about it
     */
    public static Map<RunProperty, Reachability> answer(
            Subject subject,
            Collection<RunProperty> asked,
            BiPredicate<RunProperty, Run> confirmed,
            BooleanSupplier stop) {
        SymbolicSearch search = new SymbolicSearch(subject, asked, confirmed, stop);
        search.run();
        return search.answers;
    }

    private void run() {
        for (int length = 0; length <= LONGEST && !open.isEmpty(); length++) {
            fromStart.extend();
            fromAnywhere.extend();
            List.copyOf(bounds).forEach(this::prove);
            for (RunProperty property : List.copyOf(open)) {
                if (stop.getAsBoolean()) {
                    giveUp("time or patience is up");
                    return;
                }
                look(property);
            }
        }
        giveUp("no run of up to " + LONGEST + " letters shows it, and induction leaves it open");
    }

    /** A bound that is not kept, or that the solver cannot decide about, is of no use. */
    private void prove(StatePredicate bound) {
        if (fromStart.endsWith(bound, run -> {}) != Solver.Answer.NO) {
            bounds.remove(bound);
        } else if (fromAnywhere.endsFirstWith(bound) == Solver.Answer.NO) {
            bounds.remove(bound);
            fromAnywhere.exclude(bound);
        }
    }

    private void look(RunProperty property) {
        if (doubtful.contains(property)) {
            return;
        }
        Solver.Answer shown = fromStart.endsWith(property::match, run -> found(property, run));
        if (shown == Solver.Answer.UNKNOWN) {
            doubtful.add(property);
        } else if (shown == Solver.Answer.NO
                && fromAnywhere.endsFirstWith(property::match) == Solver.Answer.NO) {
            settle(property, new Unreachable());
            fromAnywhere.exclude(property::match);
        }
    }

    private void found(RunProperty property, Run run) {
        settle(
                property,
                confirmed.test(property, run)
                        ? new Reachable(run)
                        : new Unknown("it cannot be put exactly to the solver"));
    }

    private void settle(RunProperty property, Reachability answer) {
        open.remove(property);
        answers.put(property, answer);
    }

    private void giveUp(String reason) {
        for (RunProperty property : List.copyOf(open)) {
            boolean unsure = doubtful.contains(property);
            settle(property, new Unknown(unsure ? "the solver gave up" : reason));
        }
    }
}

package arcomat.analysis.reachability;

import arcomat.analysis.reachability.Reachability.Reachable;
import arcomat.analysis.reachability.Reachability.Run;
import arcomat.analysis.reachability.Reachability.Unknown;
import arcomat.analysis.reachability.Reachability.Unreachable;
import arcomat.analysis.reachability.Unrolling.StatePredicate;

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
 *
 * @param <T> formulas of the solver that is asked
 */
public final class SymbolicSearch<T> {
    /** Longer runs are not looked for. */
    private static final int LONGEST = 12;

    private final BiPredicate<RunProperty, Run> confirmed;
    private final BooleanSupplier stop;
    private final Unrolling<T> fromStart;
    private final Unrolling<T> fromAnywhere;
    private final Set<StatePredicate<T>> bounds = new LinkedHashSet<>();
    private final Set<RunProperty> open;
    private final Set<RunProperty> doubtful = new LinkedHashSet<>();
    private final Map<RunProperty, Reachability> answers = new LinkedHashMap<>();

    private SymbolicSearch(
            Unrolling<T> fromStart,
            Unrolling<T> fromAnywhere,
            Collection<RunProperty> asked,
            BiPredicate<RunProperty, Run> confirmed,
            BooleanSupplier stop) {
        this.confirmed = confirmed;
        this.stop = stop;
        this.fromStart = fromStart;
        this.fromAnywhere = fromAnywhere;
        this.open = new LinkedHashSet<>(asked);
    }

    /**
     * @param kinds of solvers; the next one is asked what stays open where the one before could not
     *     say all exactly
     * @param facts what is known of configurations that runs reach: induction begins with no others
     * @param confirmed whether the automaton itself agrees with a run that was found
     * @param stop asked now and then; what is open then stays open
     * @return for each property what is known about it
     */
    public static Map<RunProperty, Reachability> answer(
            Subject subject,
            Collection<RunProperty> asked,
            List<Logic.Kind<?>> kinds,
            StateFacts facts,
            BiPredicate<RunProperty, Run> confirmed,
            BooleanSupplier stop) {
        Map<RunProperty, Reachability> answers = new LinkedHashMap<>();
        Collection<RunProperty> open = asked;
        boolean exact = false;
        for (int i = 0; i < kinds.size() && !open.isEmpty() && !exact; i++) {
            SymbolicSearch<?> search = of(subject, open, kinds.get(i), facts, confirmed, stop);
            search.run();
            answers.putAll(search.answers);
            exact = search.isExact();
            open = asked.stream().filter(each -> answers.get(each) instanceof Unknown).toList();
        }
        return answers;
    }

    private static <T> SymbolicSearch<T> of(
            Subject subject,
            Collection<RunProperty> asked,
            Logic.Kind<T> kind,
            StateFacts facts,
            BiPredicate<RunProperty, Run> confirmed,
            BooleanSupplier stop) {
        Logic<T> logic = kind.about(subject, stop);
        Unrolling<T> fromAnywhere = new Unrolling<>(subject, false, logic);
        fromAnywhere.exclude(facts.contradicted(logic));
        SymbolicSearch<T> search =
                new SymbolicSearch<>(
                        new Unrolling<>(subject, true, kind.about(subject, stop)),
                        fromAnywhere,
                        asked,
                        confirmed,
                        stop);
        Bounds.candidates(subject).forEach(bound -> search.bounds.add(there -> there.holds(bound)));
        return search;
    }

    private boolean isExact() {
        return fromStart.isExact() && fromAnywhere.isExact();
    }

    private void run() {
        for (int length = 0; length <= LONGEST && !doubtful.containsAll(open); length++) {
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
    private void prove(StatePredicate<T> bound) {
        if (fromStart.endsWith(bound) != Logic.Answer.NO) {
            bounds.remove(bound);
        } else if (fromAnywhere.endsFirstWith(bound) == Logic.Answer.NO) {
            bounds.remove(bound);
            fromAnywhere.exclude(bound);
        }
    }

    private void look(RunProperty property) {
        if (doubtful.contains(property)) {
            return;
        }
        Logic.Answer shown = fromStart.endsWith(property::match, run -> found(property, run));
        if (shown == Logic.Answer.UNKNOWN) {
            doubtful.add(property);
        } else if (shown == Logic.Answer.NO
                && fromAnywhere.endsFirstWith(property::match) == Logic.Answer.NO) {
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

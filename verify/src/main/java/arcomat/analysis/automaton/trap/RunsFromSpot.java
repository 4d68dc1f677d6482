package arcomat.analysis.automaton.trap;

import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.Reachability.Run;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.reachability.SymbolicTransitions;
import arcomat.analysis.reachability.Unrolling;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * Looks for shortest runs from one configuration, reached or not: of 0, 1, 2, .. inputs from there.
 *
 * @param <T> formulas of the solver
 */
final class RunsFromSpot<T> {
    /** Longer runs are not looked for. */
    static final int LONGEST = 12;

    private final Subject subject;
    private final Logic.Kind<T> kind;
    private final BooleanSupplier stop;

    /** All runs of one length, by that length. */
    private final List<Bounded<T>> bounded = new ArrayList<>();

    private record Bounded<T>(Logic<T> logic, Unrolling<T> runs) {}

    /**
     * What is so or not at the end of runs.
     *
     * @param <T> formulas of the solver
     */
    interface Ending<T> {
        T at(int length, SymbolicTransitions<T> there, Logic<T> logic);
    }

    RunsFromSpot(Subject subject, Logic.Kind<T> kind, BooleanSupplier stop) {
        this.subject = subject;
        this.kind = kind;
        this.stop = stop;
    }

    /**
     * A run with an ending; nothing where there is none, or none is found.
     *
     * @param least inputs, where it is known that less are not enough
     */
    Optional<Run> shortest(Spot spot, int least, int most, Ending<T> ending) {
        Logic.Answer answer = Logic.Answer.NO;
        for (int i = least; i <= most && answer == Logic.Answer.NO; i++) {
            int length = i;
            Bounded<T> all = ofLength(length);
            List<Run> found = new ArrayList<>();
            answer =
                    all.runs.leads(
                            there -> spot.at(there, subject, all.logic),
                            there -> ending.at(length, there, all.logic),
                            found::add);
            if (answer == Logic.Answer.YES) {
                return Optional.of(found.get(0));
            }
            if (isEnd(spot, all)) {
                return Optional.empty();
            }
        }
        return Optional.empty();
    }

    private Bounded<T> ofLength(int length) {
        while (bounded.size() <= length) {
            Logic<T> logic = kind.about(subject, stop);
            Unrolling<T> runs = new Unrolling<>(subject, false, logic);
            for (int i = 0; i <= bounded.size(); i++) {
                runs.extend();
            }
            bounded.add(new Bounded<>(logic, runs));
        }
        return bounded.get(length);
    }

    /** No run from there is so long. */
    private boolean isEnd(Spot spot, Bounded<T> all) {
        return all.runs.leads(
                        there -> spot.at(there, subject, all.logic),
                        there -> all.logic.of(true),
                        run -> {})
                == Logic.Answer.NO;
    }

    /** Whether nothing so far had to be replaced by something that may be anything. */
    boolean isExact() {
        return bounded.stream().allMatch(each -> each.logic.isExact());
    }

    /** Whether some run from there is in a state at its end. */
    boolean reaches(int state, Spot spot) {
        return shortest(spot, 0, LONGEST, (length, there, logic) -> there.instant().isIn(state))
                .isPresent();
    }
}

package arcomat.analysis.automaton.induction;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.automaton.exploration.Solving;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.StateFacts;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.search.Budget;

import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Has solvers asked once more about what stayed open: with what always holds in each state.
 * Induction begins anywhere, also where no run ever comes; what keeps it from there is an auxiliary
 * invariant (Manna, Pnueli, <i>Temporal Verification of Reactive Systems: Safety</i>, 1995).
 */
public final class Strengthening {
    /** How often a solver may ask whether to go on; the same on every machine. */
    private static final long PATIENCE = 30_000;

    private Strengthening() {}

    /**
     * The same knowledge, and more where something was open.
     *
     * @param watching is shown what is found
     */
    public static Knowledge of(Knowledge known, Consumer<Situation> watching, Budget budget) {
        Knowledge surer = known;
        StateFacts facts = StateFacts.NONE;
        for (Logic.Kind<?> kind : Solving.SOLVERS) {
            if (surer.isOpen()) {
                facts = facts.and(found(surer, facts, kind, budget.patient(PATIENCE)::isSpent));
                surer = new Solving(known.subject(), watching, budget).again(surer, facts);
            }
        }
        return surer;
    }

    private static <T> StateFacts found(
            Knowledge known, StateFacts facts, Logic.Kind<T> kind, BooleanSupplier stop) {
        Subject subject = known.subject();
        List<Move> moves = Move.all(known);
        InductiveConditions<T> induction =
                new InductiveConditions<>(subject, moves, kind.about(subject, stop));
        induction.know(facts);
        return induction.ofRuns(new CandidateConditions(subject, moves).all());
    }
}

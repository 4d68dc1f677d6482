package arcomat.analysis.automaton.trap;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.SureSending;
import arcomat.analysis.automaton.exploration.Traps;
import arcomat.analysis.automaton.induction.Move;
import arcomat.analysis.bits.BitLogic;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.system.ConfigurationText;
import arcomat.analysis.smt.LinearLogic;

import java.util.Set;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;

/**
 * Whether some run comes to where nothing is sent any more, asked of the solvers: linear arithmetic
 * first, bits where that does not tell.
 */
public final class TrapSearch {
    /** How often solvers may ask whether to go on; the same on every machine. */
    private static final long PATIENCE = 60_000;

    private final Subject subject;
    private final Knowledge known;
    private final BooleanSupplier stop;

    private TrapSearch(Knowledge known, Budget budget) {
        this.subject = known.subject();
        this.known = known;
        this.stop = budget.patient(PATIENCE)::isSpent;
    }

    /** What is known of traps, after all else has been asked. */
    public static Traps of(Knowledge known, Budget budget) {
        return known.isUnasked() || known.isExhaustive() || !new SureSending(known).isOpen()
                ? Traps.NONE
                : new TrapSearch(known, budget).traps();
    }

    private Traps traps() {
        Set<Integer> states = new TreeSet<>();
        for (int state = 0; state < subject.automaton().states().size(); state++) {
            if (!known.neverHappens(new RunProperty.Reached(state))) {
                states.add(state);
            }
        }
        Insight insight = new Insight(subject, states);
        if (!isConclusive(insight, LinearLogic.KIND)) {
            isConclusive(insight, BitLogic.KIND);
        }
        Traps traps = new TrapEntries(subject, known, insight, stop).traps();
        return insight.open().isEmpty() ? traps : new Traps(traps.entered(), open(insight));
    }

    /** Asks solvers of one kind; whether others would not find out more. */
    private <T> boolean isConclusive(Insight insight, Logic.Kind<T> kind) {
        Settling<T> settling = new Settling<>(subject, Move.all(known), insight, kind, stop);
        settling.run();
        return settling.isConclusive();
    }

    private String open(Insight insight) {
        int state = insight.open().iterator().next();
        Spot spot = insight.stuck.get(state);
        String reason =
                spot == null
                        ? "the solver does not come to an end with state " + subject.state(state)
                        : "whether something can be sent from %s on is not known, nor whether a run gets there"
                                .formatted(
                                        ConfigurationText.of(
                                                subject.automaton(), spot.configuration()));
        String wide =
                subject.automaton().variables().stream()
                        .filter(each -> Subject.isWide(each.type()))
                        .map(each -> "'" + each.name() + "'")
                        .collect(Collectors.joining(", "));
        return reason + (wide.isEmpty() ? "" : "; a range of " + wide + " would help");
    }
}

package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.automaton.exploration.Solving;
import arcomat.analysis.automaton.induction.Strengthening;
import arcomat.analysis.automaton.trap.TrapSearch;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Fault;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;

/** All analyses of one automaton. */
public final class Analyses {
    /** In alphabetical order. */
    static final List<Function<Subject, Analysis>> ALL =
            List.of(
                    Completeness::new,
                    DeadTransition::new,
                    DivisionByZero::new,
                    ForgottenSilence::new,
                    IntegerOverflow::new,
                    Overlap::new,
                    RangeOverflow::new,
                    Trap::new,
                    UnreachableState::new,
                    VacuousOnSilence::new);

    private static final long FIRST_STATES = 50_000;

    private static final Comparator<Finding> ORDER =
            Comparator.comparing(Finding::diagnostic, Diagnostic.ORDER);

    private Analyses() {}

    /**
     * Each automaton of a promise on its own.
     *
     * @param outside what others ask besides
     */
    public static List<Examination> examine(
            Promise promise, List<OutsideQuestion> outside, Budget budget) {
        return promise.each().stream()
                .filter(each -> !each.automata().isEmpty())
                .map(each -> examineSole(each, outside, budget))
                .toList();
    }

    private static Examination examineSole(
            Promise promise, List<OutsideQuestion> outside, Budget budget) {
        Automaton automaton = promise.automata().get(0);
        Subject subject;
        try {
            subject = Subject.of(promise.component(), automaton, promise.arguments());
        } catch (Fault fault) {
            List<Finding> findings = List.of(beginning(fault, automaton));
            return new Examination(promise, findings, "", 0);
        }
        List<Analysis> analyses = new ArrayList<>();
        ALL.forEach(each -> analyses.add(each.apply(subject)));
        outside.forEach(each -> analyses.add(new OutsideAnalysis(each, subject)));
        Consumer<Situation> watching = seen -> analyses.forEach(each -> each.see(seen));
        Exploration exploration = new Exploration(subject, watching, firstBudget(subject, budget));
        return Budget.within(
                () -> {
                    exploration.run();
                    Knowledge solved = new Solving(subject, watching, budget).after(exploration);
                    Knowledge surer = Strengthening.of(solved, watching, budget);
                    Knowledge known = surer.with(TrapSearch.of(surer, budget));
                    List<Finding> findings =
                            analyses.stream()
                                    .flatMap(each -> each.findings(known).stream())
                                    .sorted(ORDER)
                                    .toList();
                    return new Examination(
                            promise, findings, obstacle(known, outside), exploration.size());
                },
                reason -> new Examination(promise, List.of(), reason, exploration.size()));
    }

    /** A solver answers the tool's questions, and not those of others: they have seen a part. */
    private static String obstacle(Knowledge known, List<OutsideQuestion> outside) {
        String obstacle = known.obstacle();
        return obstacle.isEmpty() && !outside.isEmpty() && !known.isExhaustive()
                ? "guests were asked about some of the configurations only (%s)"
                        .formatted(known.explored().obstacle())
                : obstacle;
    }

    /** Where there is no end to the values, the solver is asked soon. */
    private static Budget firstBudget(Subject subject, Budget budget) {
        return subject.isWide() ? budget.atMost(FIRST_STATES) : budget;
    }

    /** The automaton goes wrong before it reads anything. */
    private static Finding beginning(Fault fault, Automaton automaton) {
        String code =
                switch (fault.kind()) {
                    case DIVISION_BY_ZERO -> DivisionByZero.CODE;
                    case OUTSIDE_RANGE -> RangeOverflow.CODE;
                };
        return Finding.never(
                Diagnostic.error(
                        code,
                        automaton.initials().get(0).span(),
                        "run error at the start: " + fault.getMessage()));
    }
}

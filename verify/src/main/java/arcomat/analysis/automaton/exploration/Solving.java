package arcomat.analysis.automaton.exploration;

import arcomat.analysis.bits.BitLogic;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.Reachability;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.StateFacts;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.reachability.SymbolicSearch;
import arcomat.analysis.search.Budget;
import arcomat.analysis.smt.LinearLogic;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/** Puts to the solver what trying has left open, and shows what it found to who watches. */
public final class Solving {
    /** More questions are not put: two for each pair of transitions, say. */
    private static final int MOST_QUESTIONS = 1500;

    /** How often the solver may ask whether to go on; the same on every machine. */
    private static final long PATIENCE = 30_000;

    /** In the order in which they are asked. */
    public static final List<Logic.Kind<?>> SOLVERS = List.of(LinearLogic.KIND, BitLogic.KIND);

    private final Subject subject;
    private final Consumer<Situation> watching;
    private final Budget budget;
    private final Confirmation confirmation;
    private final Map<RunProperty, Situation> found = new LinkedHashMap<>();

    public Solving(Subject subject, Consumer<Situation> watching, Budget budget) {
        this.subject = subject;
        this.watching = watching;
        this.budget = budget;
        this.confirmation = new Confirmation(subject, Stepper.of(subject));
    }

    /** Puts what trying has left open. */
    public Knowledge after(Exploration explored) {
        List<RunProperty> open = open(explored);
        boolean few = open.size() <= MOST_QUESTIONS;
        return knowledge(
                explored, explored.shown(), few ? answers(open, StateFacts.NONE) : Map.of());
    }

    /**
     * Puts what is still open once more.
     *
     * @param facts what is known of configurations that runs reach
     */
    public Knowledge again(Knowledge known, StateFacts facts) {
        Map<RunProperty, Reachability> answers = new LinkedHashMap<>(known.answers());
        answers.putAll(answers(known.unknown(), facts));
        return knowledge(known.explored(), known.shown(), answers);
    }

    private Map<RunProperty, Reachability> answers(List<RunProperty> open, StateFacts facts) {
        return SymbolicSearch.answer(
                subject, open, SOLVERS, facts, this::confirm, budget.patient(PATIENCE)::isSpent);
    }

    private Knowledge knowledge(
            Exploration explored, Set<RunProperty> before, Map<RunProperty, Reachability> answers) {
        Set<RunProperty> shown = new HashSet<>(before);
        found.values().forEach(situation -> shown.addAll(situation.shows()));
        found.values().forEach(watching);
        return new Knowledge(subject, explored, shown, answers);
    }

    private List<RunProperty> open(Exploration explored) {
        if (explored.isComplete()) {
            return List.of();
        }
        List<RunProperty> open = new RunProperties(subject).all();
        open.removeAll(explored.shown());
        return open;
    }

    private boolean confirm(RunProperty property, Reachability.Run run) {
        Optional<Situation> situation = confirmation.of(property, run);
        situation.ifPresent(there -> found.put(property, there));
        return situation.isPresent();
    }
}

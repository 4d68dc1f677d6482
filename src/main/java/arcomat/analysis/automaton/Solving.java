package arcomat.analysis.automaton;

import arcomat.analysis.search.Budget;
import arcomat.analysis.smt.Reachability;
import arcomat.analysis.smt.RunProperty;
import arcomat.analysis.smt.Subject;
import arcomat.analysis.smt.SymbolicSearch;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Puts to the solver what trying has left open, and shows what it found to those who watch. */
final class Solving {
    /** More questions are not put: two for each pair of transitions, say. */
    private static final int MOST_QUESTIONS = 1500;

    /** How often the solver may ask whether to go on; the same on every machine. */
    private static final long PATIENCE = 30_000;

    private final Subject subject;
    private final List<? extends Watcher> watching;
    private final Seen seen;
    private final Budget budget;
    private final Walk walk;
    private final Map<RunProperty, Situation> found = new LinkedHashMap<>();

    Solving(Subject subject, List<? extends Watcher> watching, Seen seen, Budget budget) {
        this.subject = subject;
        this.watching = watching;
        this.seen = seen;
        this.budget = budget;
        this.walk = new Walk(subject, Stepper.of(subject));
    }

    Knowledge after(Exploration explored) {
        for (int state = 0; state < subject.automaton().states().size(); state++) {
            if (explored.hasReached(state)) {
                seen.questions().add(new RunProperty.Reached(state));
            }
        }
        List<RunProperty> questions = open(explored);
        Map<RunProperty, Reachability> outcomes = Map.of();
        if (!questions.isEmpty() && questions.size() <= MOST_QUESTIONS) {
            outcomes =
                    SymbolicSearch.answer(
                            subject, questions, this::confirm, budget.patient(PATIENCE)::isSpent);
        }
        found.values().forEach(this::show);
        return new Knowledge(explored, seen.questions(), outcomes);
    }

    private List<RunProperty> open(Exploration explored) {
        if (explored.isComplete()) {
            return List.of();
        }
        List<RunProperty> open = new Questions(subject).all();
        open.removeAll(seen.questions());
        return open;
    }

    private boolean confirm(RunProperty question, Reachability.Run run) {
        Optional<Situation> situation = walk.to(question, run);
        situation.ifPresent(there -> found.put(question, there));
        return situation.isPresent();
    }

    private void show(Situation situation) {
        watching.forEach(each -> each.see(situation));
        seen.questions().addAll(Seen.shownBy(situation));
    }
}

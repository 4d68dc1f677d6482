package arcomat.analysis.automaton;

import arcomat.analysis.Budget;
import arcomat.analysis.smt.Outcome;
import arcomat.analysis.smt.Question;
import arcomat.analysis.smt.SymbolicSearch;
import arcomat.model.Automaton;
import arcomat.model.Expression;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

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
    private final Map<Question, Situation> found = new LinkedHashMap<>();

    Solving(Subject subject, List<? extends Watcher> watching, Seen seen, Budget budget) {
        this.subject = subject;
        this.watching = watching;
        this.seen = seen;
        this.budget = budget;
        this.walk = new Walk(subject, new Stepper(subject));
    }

    Knowledge after(Exploration explored) {
        for (int state = 0; state < subject.automaton().states().size(); state++) {
            if (explored.hasReached(state)) {
                seen.questions().add(new Question.Reached(state));
            }
        }
        List<Question> questions = open(explored);
        Map<Question, Outcome> outcomes = Map.of();
        if (!questions.isEmpty() && questions.size() <= MOST_QUESTIONS) {
            outcomes =
                    SymbolicSearch.answer(
                            subject.component(),
                            subject.relation(),
                            subject.arguments(),
                            questions,
                            this::confirm,
                            budget.patient(PATIENCE)::isSpent);
        }
        Map<Integer, Situation> overflows = new TreeMap<>();
        found.forEach((question, situation) -> show(question, situation, overflows));
        return new Knowledge(explored, seen.questions(), outcomes, overflows);
    }

    private List<Question> open(Exploration explored) {
        List<Question> open = new ArrayList<>();
        if (!explored.isComplete()) {
            open.addAll(new Questions(subject).all());
            open.removeAll(seen.questions());
        }
        for (int i = 0; i < subject.automaton().transitions().size(); i++) {
            if (mayOverflow(subject.transition(i))) {
                open.add(new Question.Overflow(i));
            }
        }
        return open;
    }

    private static boolean mayOverflow(Automaton.Transition transition) {
        List<Expression> all = new ArrayList<>();
        transition.guard().ifPresent(all::add);
        for (Automaton.Send send : transition.sends()) {
            if (send.emission() instanceof Automaton.Messages messages) {
                all.addAll(messages.values());
            }
        }
        transition.assignments().forEach(assignment -> all.add(assignment.value()));
        return all.stream().anyMatch(Intervals::mayOverflow);
    }

    private boolean confirm(Question question, Outcome.Run run) {
        Optional<Situation> situation = walk.to(question, run);
        situation.ifPresent(there -> found.put(question, there));
        return situation.isPresent();
    }

    private void show(Question question, Situation situation, Map<Integer, Situation> overflows) {
        if (question instanceof Question.Overflow overflow) {
            overflows.put(overflow.transition(), situation);
            return;
        }
        watching.forEach(each -> each.see(situation));
        seen.questions().addAll(Seen.shownBy(situation));
    }
}

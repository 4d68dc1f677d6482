package arcomat.analysis.smt;

import arcomat.analysis.smt.Outcome.Found;
import arcomat.analysis.smt.Outcome.Impossible;
import arcomat.analysis.smt.Outcome.Open;
import arcomat.analysis.smt.Outcome.Run;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.semantics.automaton.StepRelation;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.BooleanSupplier;

/**
 * Answers questions about runs of any length. For k = 0, 1, 2, ..: is there a run of k letters that
 * shows it (bounded model checking)? If not: after k configurations, wherever they come from, that
 * do not show it, can the next one show it? If not either, none ever does (k-induction). What is
 * known to be impossible helps with the rest, as do {@link Bounds} that nobody asked for.
 */
public final class SymbolicSearch {
    /** Longer runs are not looked for. */
    static final int LONGEST = 12;

    private final BiPredicate<Question, Run> confirmed;
    private final BooleanSupplier stop;
    private final Runs fromStart;
    private final Runs fromAnywhere;
    private final Set<Question> bounds;
    private final Set<Question> open;
    private final Set<Question> doubtful = new LinkedHashSet<>();
    private final Map<Question, Outcome> outcomes = new LinkedHashMap<>();

    private SymbolicSearch(
            Symbols symbols,
            StepRelation relation,
            Collection<Question> questions,
            BiPredicate<Question, Run> confirmed,
            BooleanSupplier stop) {
        this.confirmed = confirmed;
        this.stop = stop;
        this.fromStart = new Runs(symbols, Optional.of(relation), stop);
        this.fromAnywhere = new Runs(symbols, Optional.empty(), stop);
        this.bounds = new LinkedHashSet<>(Bounds.candidates(relation));
        this.open = new LinkedHashSet<>(questions);
    }

    /**
     * @param arguments one per parameter of the component
     * @param conditions one per transition
     * @param confirmed whether the automaton itself agrees with a run that was found
     * @param stop asked now and then; what is open then stays open
     * @return an outcome for each question
     */
    public static Map<Question, Outcome> answer(
            Component component,
            StepRelation relation,
            List<Value> arguments,
            List<Condition> conditions,
            Collection<Question> questions,
            BiPredicate<Question, Run> confirmed,
            BooleanSupplier stop) {
        Automaton automaton = relation.automaton();
        Symbols symbols = new Symbols(component, automaton, arguments, conditions);
        SymbolicSearch search = new SymbolicSearch(symbols, relation, questions, confirmed, stop);
        search.run();
        return search.outcomes;
    }

    private void run() {
        for (int length = 0; length <= LONGEST && !open.isEmpty(); length++) {
            fromStart.extend();
            fromAnywhere.extend();
            List.copyOf(bounds).forEach(this::prove);
            for (Question question : List.copyOf(open)) {
                if (stop.getAsBoolean()) {
                    giveUp("time or patience is up");
                    return;
                }
                look(question);
            }
        }
        giveUp("no run of up to " + LONGEST + " letters shows it, and induction leaves it open");
    }

    /** A bound that is not kept, or that the solver cannot decide about, is of no use. */
    private void prove(Question bound) {
        if (fromStart.endsWith(bound, run -> {}) != Solver.Answer.NO) {
            bounds.remove(bound);
        } else if (fromAnywhere.endsFirstWith(bound) == Solver.Answer.NO) {
            bounds.remove(bound);
            fromAnywhere.exclude(bound);
        }
    }

    private void look(Question question) {
        if (doubtful.contains(question)) {
            return;
        }
        Solver.Answer shown = fromStart.endsWith(question, run -> found(question, run));
        if (shown == Solver.Answer.UNKNOWN) {
            doubtful.add(question);
        } else if (shown == Solver.Answer.NO
                && fromAnywhere.endsFirstWith(question) == Solver.Answer.NO) {
            settle(question, new Impossible());
            fromAnywhere.exclude(question);
        }
    }

    private void found(Question question, Run run) {
        settle(
                question,
                confirmed.test(question, run)
                        ? new Found(run)
                        : new Open("it cannot be put exactly to the solver"));
    }

    private void settle(Question question, Outcome outcome) {
        open.remove(question);
        outcomes.put(question, outcome);
    }

    private void giveUp(String reason) {
        for (Question question : List.copyOf(open)) {
            boolean unsure = doubtful.contains(question);
            settle(question, new Open(unsure ? "the solver gave up" : reason));
        }
    }
}

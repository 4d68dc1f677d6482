package arcomat.analysis.smt;

import arcomat.semantics.automaton.StepRelation;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** All runs up to some length, from a beginning or from anywhere, with a solver that knows them. */
final class Runs {
    private final Optional<StepRelation> beginning;
    private final Solver solver;
    private final Unrolling unrolling;
    private final List<Question> impossible = new ArrayList<>();
    private int length = -1;

    /**
     * @param beginning whose beginnings the runs start with; anywhere if empty
     */
    Runs(Symbols symbols, Optional<StepRelation> beginning, BooleanSupplier stop) {
        this.beginning = beginning;
        this.solver = new Solver(stop);
        this.unrolling = new Unrolling(symbols, solver);
    }

    /** Makes the runs one letter longer; at first, they have none. */
    void extend() {
        length++;
        unrolling.extend();
        if (length == 0) {
            beginning.ifPresent(unrolling::begin);
        }
        impossible.forEach(known -> claimNever(known, length));
    }

    /** It is known that no configuration shows it. */
    void exclude(Question question) {
        impossible.add(question);
        for (int i = 0; i <= length; i++) {
            claimNever(question, i);
        }
    }

    private void claimNever(Question question, int instant) {
        solver.claim(solver.not(unrolling.holds(question, instant)));
    }

    /** Whether the end of a run shows it; if so, looks at an example. */
    Solver.Answer endsWith(Question question, Consumer<Outcome.Run> example) {
        return ask(
                List.of(unrolling.holds(question, length)),
                () -> example.accept(unrolling.run(length)));
    }

    /** Whether the end of a run may be the first to show it. */
    Solver.Answer endsFirstWith(Question question) {
        List<Term> assumed = new ArrayList<>();
        for (int i = 0; i < length; i++) {
            assumed.add(solver.not(unrolling.holds(question, i)));
        }
        assumed.add(unrolling.holds(question, length));
        return ask(assumed, () -> {});
    }

    private Solver.Answer ask(List<Term> assumed, Runnable ifYes) {
        return solver.assuming(
                assumed,
                answer -> {
                    if (answer == Solver.Answer.YES) {
                        ifYes.run();
                    }
                    return answer;
                });
    }
}

package arcomat.analysis.smt;

import arcomat.analysis.smt.Reachability.Place;
import arcomat.analysis.smt.Reachability.Run;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.automaton.StepRelation.Start;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * All runs of one automaton up to some length, from a beginning or from anywhere, as claims to a
 * solver. On the way nothing goes wrong.
 */
final class Unrolling {
    private final Subject subject;
    private final boolean begins;
    private final Solver solver;
    private final Encoding codes;
    private final List<Instant> instants = new ArrayList<>();
    private final List<SymbolicTransitions> transitions = new ArrayList<>();
    private final List<StatePredicate> impossible = new ArrayList<>();

    /** What is so or not at an instant. */
    interface StatePredicate {
        Term at(SymbolicTransitions there);
    }

    /**
     * @param begins whether runs start with a beginning of the automaton; else anywhere
     */
    Unrolling(Subject subject, boolean begins, BooleanSupplier stop) {
        this.subject = subject;
        this.begins = begins;
        this.solver = new Solver(stop);
        this.codes = new Encoding(solver, false);
    }

    /** Makes the runs one letter longer; at first, they have none. */
    void extend() {
        int number = instants.size();
        Instant next = new Instant(subject, solver, codes, number);
        instants.add(next);
        transitions.add(new SymbolicTransitions(subject, next, solver, codes));
        solver.claim(next.wellFormed());
        if (number > 0) {
            step(number - 1, next);
        } else if (begins) {
            List<Start> starts = subject.relation().starts();
            solver.claim(solver.or(starts.stream().map(this::begins).toList()));
        }
        impossible.forEach(known -> claimNever(known, number));
    }

    private void step(int number, Instant next) {
        solver.claim(instants.get(number).keepsLatched(next));
        List<Term> steps = new ArrayList<>();
        for (int i = 0; i < subject.automaton().transitions().size(); i++) {
            steps.add(transitions.get(number).step(i, next));
        }
        solver.claim(solver.or(steps));
    }

    private Term begins(Start start) {
        Instant first = instants.get(0);
        List<Term> all = new ArrayList<>();
        all.add(first.isIn(start.configuration().state()));
        List<Variable> variables = subject.automaton().variables();
        for (int i = 0; i < variables.size(); i++) {
            if (codes.isExact(variables.get(i).type())) {
                Term code = first.variable(variables.get(i));
                Term value =
                        codes.encode(
                                start.configuration().variables().get(i), variables.get(i).type());
                all.add(solver.equal(code, value));
            }
        }
        return solver.and(all);
    }

    /** It is known that no configuration shows it. */
    void exclude(StatePredicate shown) {
        impossible.add(shown);
        for (int i = 0; i < instants.size(); i++) {
            claimNever(shown, i);
        }
    }

    private void claimNever(StatePredicate shown, int instant) {
        solver.claim(solver.not(holds(shown, instant)));
    }

    private Term holds(StatePredicate shown, int instant) {
        return shown.at(transitions.get(instant));
    }

    /** Whether the end of a run shows it; if so, looks at an example. */
    Solver.Answer endsWith(StatePredicate shown, Consumer<Run> example) {
        Term atEnd = holds(shown, instants.size() - 1);
        return solver.assuming(List.of(atEnd), () -> example.accept(run()));
    }

    /** Whether the end of a run may be the first to show it. */
    Solver.Answer endsFirstWith(StatePredicate shown) {
        int last = instants.size() - 1;
        List<Term> assumed = new ArrayList<>();
        for (int i = 0; i < last; i++) {
            assumed.add(solver.not(holds(shown, i)));
        }
        assumed.add(holds(shown, last));
        return solver.assuming(assumed, () -> {});
    }

    /** After the answer yes: the example's run, with the letter at its end. */
    private Run run() {
        List<Place> places = instants.stream().map(Instant::place).toList();
        List<Value[]> letters = instants.stream().map(Instant::letter).toList();
        int last = letters.size() - 1;
        return new Run(letters.subList(0, last), places, letters.get(last));
    }
}

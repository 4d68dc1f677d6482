package arcomat.analysis.smt;

import arcomat.analysis.smt.Outcome.Place;
import arcomat.analysis.smt.Outcome.Run;
import arcomat.model.Automaton;
import arcomat.model.Value;
import arcomat.semantics.automaton.Start;
import arcomat.semantics.automaton.StepRelation;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.util.ArrayList;
import java.util.List;

/**
 * Runs of one automaton up to some length, as claims to a solver. On the way nothing goes wrong.
 */
final class Unrolling {
    private final Symbols symbols;
    private final Solver solver;
    private final Codes codes = new Codes();
    private final List<Instant> instants = new ArrayList<>();
    private final List<Behaving> behaving = new ArrayList<>();

    Unrolling(Symbols symbols, Solver solver) {
        this.symbols = symbols;
        this.solver = solver;
    }

    /** The first instant is one of the automaton's beginnings. */
    void begin(StepRelation relation) {
        List<Term> beginnings = new ArrayList<>();
        for (Start start : relation.starts()) {
            beginnings.add(at(0, start));
        }
        solver.claim(solver.or(beginnings));
    }

    private Term at(int number, Start start) {
        List<Term> all = new ArrayList<>();
        all.add(instants.get(number).isIn(start.configuration().state()));
        List<Value> values = start.configuration().variables();
        for (int i = 0; i < values.size(); i++) {
            var variable = symbols.automaton().variables().get(i);
            if (Codes.isExact(variable.type())) {
                Term code = instants.get(number).variable(variable);
                all.add(solver.equal(code, codes.encode(values.get(i), solver)));
            }
        }
        return solver.and(all);
    }

    /** Adds an instant, and a step to it from the last one. */
    void extend() {
        int number = instants.size();
        Instant next = new Instant(symbols.component(), symbols.automaton(), solver, codes, number);
        instants.add(next);
        behaving.add(new Behaving(symbols, next, solver, codes));
        solver.claim(next.wellFormed());
        if (number > 0) {
            Instant last = instants.get(number - 1);
            solver.claim(last.keepsLatched(next));
            List<Term> steps = new ArrayList<>();
            List<Automaton.Transition> transitions = symbols.automaton().transitions();
            for (int i = 0; i < transitions.size(); i++) {
                steps.add(behaving.get(number - 1).step(i, next));
            }
            solver.claim(solver.or(steps));
        }
    }

    /** What a question asks of one instant. */
    Term holds(Question question, int number) {
        return new Asking(symbols, instants.get(number), behaving.get(number), solver)
                .holds(question);
    }

    /** After the answer yes: the example's run to an instant, with the letter there. */
    Run run(int last) {
        List<Value[]> letters = new ArrayList<>();
        List<Place> places = new ArrayList<>();
        for (int i = 0; i <= last; i++) {
            Instant instant = instants.get(i);
            places.add(instant.place());
            letters.add(instant.letter());
        }
        return new Run(letters.subList(0, last), places, letters.get(last));
    }
}

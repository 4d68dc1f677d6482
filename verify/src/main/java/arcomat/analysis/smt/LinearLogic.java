package arcomat.analysis.smt;

import arcomat.analysis.reachability.Instant;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.Subject;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Runs of an automaton in linear arithmetic: sums and comparisons of whole numbers are exact, by
 * whatever distance they wrap around. Products of two variables and numbers of floating point may
 * be anything.
 */
public final class LinearLogic implements Logic<Term> {
    public static final Kind<Term> KIND = LinearLogic::new;

    private final Subject subject;
    private final Solver solver;
    private final Encoding codes;
    private int instants;
    private boolean exact = true;

    private LinearLogic(Subject subject, BooleanSupplier stop) {
        this.subject = subject;
        this.solver = new Solver(stop);
        this.codes = new Encoding(solver, false);
    }

    @Override
    public Term of(boolean truth) {
        return solver.of(truth);
    }

    @Override
    public Term and(List<Term> all) {
        return solver.and(all);
    }

    @Override
    public Term or(List<Term> any) {
        return solver.or(any);
    }

    @Override
    public Term not(Term condition) {
        return solver.not(condition);
    }

    @Override
    public void claim(Term condition) {
        solver.claim(condition);
    }

    @Override
    public Answer assuming(List<Term> conditions) {
        return solver.assuming(conditions, () -> {});
    }

    @Override
    public Answer assuming(List<Term> conditions, Runnable ifYes) {
        return solver.assuming(conditions, ifYes);
    }

    @Override
    public Instant<Term> instant() {
        return new LinearInstant(subject, solver, codes, instants++, () -> exact = false);
    }

    @Override
    public boolean isExact() {
        return exact;
    }
}

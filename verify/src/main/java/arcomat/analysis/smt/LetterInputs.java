package arcomat.analysis.smt;

import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;

import de.uni_freiburg.informatik.ultimate.logic.Term;

/** The messages of one letter, on ports that carry one. There are no variables. */
final class LetterInputs implements ReadTerms {
    private final Solver solver;
    private final Encoding codes;
    private int unknowns;
    private int definitions;

    LetterInputs(Solver solver, Encoding codes) {
        this.solver = solver;
        this.codes = codes;
    }

    @Override
    public Term variable(Variable variable) {
        throw new AssertionError(variable);
    }

    @Override
    public Term message(Port port) {
        return unknown("port " + port.name(), port.type());
    }

    @Override
    public Term has(Port port) {
        return solver.of(true);
    }

    @Override
    public Term anything(Type type) {
        Term unknown = unknown("any " + unknowns++, type);
        solver.claim(codes.range(unknown, type));
        return unknown;
    }

    @Override
    public Term defined() {
        return solver.integer("value " + definitions++);
    }

    private Term unknown(String name, Type type) {
        return Encoding.isTruth(type) ? solver.truth(name) : solver.integer(name);
    }
}

package arcomat.analysis.smt;

import arcomat.semantics.expression.Fault;

import de.uni_freiburg.informatik.ultimate.logic.Term;

/** Questions as terms about one instant. */
record Asking(Symbols symbols, Instant at, Behaving behaving, Solver solver) {

    Term holds(Question question) {
        if (question instanceof Question.Reached reached) {
            return at.isIn(reached.state());
        }
        if (question instanceof Question.Enabled enabled) {
            return behaving.enabled(enabled.transition());
        }
        if (question instanceof Question.Together together) {
            return solver.and(
                    behaving.enabled(together.first()),
                    behaving.enabled(together.second()),
                    difference(together));
        }
        if (question instanceof Question.Unhandled unhandled) {
            Term silent = at.silent();
            return solver.and(
                    behaving.nothingEnabled(unhandled.state()),
                    unhandled.silent() ? silent : solver.not(silent));
        }
        if (question instanceof Question.Wrong wrong) {
            return wrong.kind() == Fault.Kind.DIVISION_BY_ZERO
                    ? behaving.dividesByZero(wrong.transition())
                    : behaving.overflowsRange(wrong.transition());
        }
        if (question instanceof Question.Beyond beyond) {
            Term value = at.variable(symbols.automaton().variables().get(beyond.variable()));
            return solver.apply(beyond.below() ? "<" : ">", value, solver.number(beyond.bound()));
        }
        if (question instanceof Question.Parity parity) {
            Term value = at.variable(symbols.automaton().variables().get(parity.variable()));
            Term rest = solver.apply("mod", value, solver.number(2));
            return solver.equal(rest, solver.number(parity.odd() ? 1 : 0));
        }
        return behaving.overflows(((Question.Overflow) question).transition());
    }

    private Term difference(Question.Together together) {
        return switch (together.difference()) {
            case ANY -> solver.of(true);
            case OUTPUT ->
                    solver.and(
                            bothGoWell(together),
                            behaving.differInOutput(together.first(), together.second()));
            case TARGET ->
                    solver.and(
                            bothGoWell(together),
                            behaving.differInTarget(together.first(), together.second()));
        };
    }

    private Term bothGoWell(Question.Together together) {
        return solver.and(
                behaving.goesWell(together.first()), behaving.goesWell(together.second()));
    }
}

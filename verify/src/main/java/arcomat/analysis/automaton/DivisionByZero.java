package arcomat.analysis.automaton;

import arcomat.analysis.reachability.Subject;
import arcomat.semantics.expression.Fault;

/** A division, or a remainder, by zero; in a guard or in what is sent or assigned. */
final class DivisionByZero extends FaultAnalysis {
    static final String CODE = "ARC1008";

    DivisionByZero(Subject subject) {
        super(CODE, Fault.Kind.DIVISION_BY_ZERO, subject);
    }
}

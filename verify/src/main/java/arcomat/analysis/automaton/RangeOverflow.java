package arcomat.analysis.automaton;

import arcomat.analysis.reachability.Subject;
import arcomat.semantics.expression.Fault;

/** A value that leaves the range of its variable or port. */
final class RangeOverflow extends FaultAnalysis {
    static final String CODE = "ARC1007";

    RangeOverflow(Subject subject) {
        super(CODE, Fault.Kind.OUTSIDE_RANGE, subject);
    }
}

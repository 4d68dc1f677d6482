package arcomat.analysis.smt;

import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;

import de.uni_freiburg.informatik.ultimate.logic.Term;

/** What expressions find where they are evaluated. */
interface ReadTerms {
    Term variable(Variable variable);

    Term message(Port port);

    /** Whether a port carries a message. */
    Term has(Port port);

    /** A value that is not modelled: it may be any of its type. */
    Term anything(Type type);

    /** A number that claims will define. */
    Term defined();
}

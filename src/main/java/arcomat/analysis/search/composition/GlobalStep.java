package arcomat.analysis.search.composition;

import arcomat.model.Trace;
import arcomat.semantics.expression.Sent;

import java.util.List;

/**
 * One way in which a network reacts.
 *
 * @param next where it is afterwards
 * @param sent one per external output of the network; empty for an error
 * @param causes what its automata did, in order
 */
public record GlobalStep(GlobalState next, List<Sent> sent, List<Trace.Cause> causes) {
    public GlobalStep {
        sent = List.copyOf(sent);
        causes = List.copyOf(causes);
    }

    /**
     * The end of the run.
     *
     * @param problem what went wrong
     */
    static GlobalStep error(String problem, List<Trace.Cause> causes) {
        return new GlobalStep(GlobalState.error(problem), List.of(), causes);
    }
}

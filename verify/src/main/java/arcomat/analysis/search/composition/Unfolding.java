package arcomat.analysis.search.composition;

import arcomat.analysis.search.letter.Representatives;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.InputAbstraction;

import java.util.List;
import java.util.Optional;

/** How a network of parts goes on, slice by slice or event by event. */
public interface Unfolding {
    /**
     * One way in which a network reacts.
     *
     * @param next where it is afterwards
     * @param sent one per external output of the network; empty for an error
     * @param causes what its automata did, in order
     */
    record Step(GlobalState next, List<Sent> sent, List<Trace.Cause> causes) {
        public Step {
            sent = List.copyOf(sent);
            causes = List.copyOf(causes);
        }

        /**
         * The end of the run.
         *
         * @param problem what went wrong
         */
        static Step error(String problem, List<Trace.Cause> causes) {
            return new Step(GlobalState.error(problem), List.of(), causes);
        }
    }

    /** One per instance of the network. */
    List<ComponentSemantics> behaviours();

    /** All ways to begin. */
    List<Step> beginnings();

    /**
     * What the reactions look at, external input by external input.
     *
     * @param standIns for data of this side of which it only matters which are the same
     */
    InputAbstraction abstraction(GlobalState whole, Representatives standIns);

    /**
     * All ways to react.
     *
     * @param letter messages by position of the external input, null for silence
     */
    List<Step> reactions(GlobalState before, Value[] letter);

    /** The signal whose message a register of a {@link GlobalState} keeps. */
    int signal(int register);

    /** Whether a message has been left open until it was read in a later slice. */
    boolean postpones();

    /** Why some ways have been left out; empty where none has been so far. */
    Optional<String> leftOut();
}

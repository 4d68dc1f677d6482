package arcomat.analysis.automaton;

import arcomat.analysis.search.letter.Letters;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.Reaction;
import arcomat.semantics.expression.Fault;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * What may happen in a reachable configuration on one kind of letter.
 *
 * @param letter messages by position of the input port, null for silence
 * @param alternatives one per enabled transition, in text order
 * @param faults of the guards that go wrong
 * @param wrapping indices of the transitions of which an integer wraps around
 */
record Situation(
        Visit visit,
        Value[] letter,
        List<Alternative> alternatives,
        List<Fault> faults,
        List<Integer> wrapping) {

    private static final Comparator<Situation> SIMPLE_FIRST =
            Comparator.<Situation>comparingInt(each -> each.visit.length())
                    .thenComparingInt(Situation::messages);

    /**
     * An enabled transition.
     *
     * @param reaction empty where the right-hand side goes wrong
     * @param next number of the visit that it leads to; -1 where it goes wrong
     */
    record Alternative(
            Trace.Taken taken, Optional<Reaction> reaction, Optional<Fault> fault, int next) {}

    int state() {
        return visit.configuration().state();
    }

    /** Whether no transition answers, well or wrong. */
    boolean isUnhandled() {
        return alternatives.isEmpty() && faults.isEmpty();
    }

    boolean isSilent() {
        return Letters.messages(letter) == 0;
    }

    /** Whether this is the better witness: the way to it is shorter, or has fewer messages. */
    boolean isSimplerThan(Situation other) {
        return SIMPLE_FIRST.compare(this, other) < 0;
    }

    private int messages() {
        return visit.messages() + Letters.messages(letter);
    }
}

package arcomat.symbols.signatures;

import arcomat.source.Span;
import arcomat.tree.Automaton;
import arcomat.tree.Behaviour;

import java.util.List;
import java.util.Optional;

/** Knows languages in which a behaviour has a meaning only where names and types are known. */
public interface BehaviourReader {
    /** Knows none. */
    BehaviourReader NONE = (behaviour, around) -> Optional.empty();

    /**
     * What a behaviour means in a component; nothing where the language is not known.
     *
     * @param behaviour that has no meaning yet
     * @param around the component, as it can be seen from outside
     */
    Optional<Reading> read(Behaviour.Foreign behaviour, Signature around);

    /**
     * What came of it.
     *
     * @param automaton empty where something is wrong
     */
    record Reading(Optional<Automaton> automaton, List<Problem> problems) {
        public Reading {
            problems = List.copyOf(problems);
        }
    }

    /**
     * Something that is wrong with a text.
     *
     * @param message as it is told
     */
    record Problem(String code, Span place, String message) {}
}

package arcomat.symbols.signatures;

import arcomat.source.Diagnostic;
import arcomat.source.Diagnostic.Related;
import arcomat.source.Fix;
import arcomat.source.Severity;
import arcomat.source.Span;
import arcomat.tree.Automaton;
import arcomat.tree.Behaviour;

import java.util.List;
import java.util.Map;
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
     * @param automaton empty where nobody can say what it means
     * @param codes with which findings of laws about it are told, by the codes of the laws
     * @param takenOver places whose text the automaton has letter by letter
     * @param names places that name a value, besides
     */
    record Reading(
            Optional<Automaton> automaton,
            List<Problem> problems,
            Map<String, String> codes,
            List<Span> takenOver,
            List<Span> names) {
        public Reading {
            problems = List.copyOf(problems);
            codes = Map.copyOf(codes);
            takenOver = List.copyOf(takenOver);
            names = List.copyOf(names);
        }

        /** Of one that means nothing. */
        public static Reading of(List<Problem> problems) {
            return new Reading(Optional.empty(), problems, Map.of(), List.of(), List.of());
        }
    }

    /**
     * Something that is wrong with a text.
     *
     * @param message as it is told
     * @param related other places that have to do with it
     * @param fix what mends it
     */
    record Problem(
            String code, Span place, String message, List<Related> related, Optional<Fix> fix) {
        public Problem {
            related = List.copyOf(related);
        }

        /** Without a word on what else has to do with it. */
        public Problem(String code, Span place, String message) {
            this(code, place, message, List.of(), Optional.empty());
        }

        /** As a finding. */
        public Diagnostic error() {
            return new Diagnostic(code, Severity.ERROR, place, message, related, fix);
        }
    }
}

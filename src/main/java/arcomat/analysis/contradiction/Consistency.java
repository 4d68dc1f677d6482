package arcomat.analysis.contradiction;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.model.Component;

import java.util.List;
import java.util.Optional;

/**
 * Whether the requirements on a component can be kept together.
 *
 * @param answer holds where there is no contradiction
 * @param reason of an unknown, what stood in the way; else empty
 * @param contradictions one, or all minimal ones; only of a failure
 * @param controller keeps all requirements; only where there is no contradiction
 * @param notes what a reader should know besides
 * @param explored positions of the games that were played
 */
public record Consistency(
        Answer answer,
        String reason,
        List<Contradiction> contradictions,
        Optional<Component> controller,
        List<String> notes,
        long explored) {
    public Consistency {
        contradictions = List.copyOf(contradictions);
        notes = List.copyOf(notes);
    }
}

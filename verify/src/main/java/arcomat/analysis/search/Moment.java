package arcomat.analysis.search;

import arcomat.model.Letter;
import arcomat.semantics.expression.Sent;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * One step of an analysis trace: an input with the reaction to it, also where the reaction is seen
 * one slice later. The first moment of a trace has the initial outputs and no input.
 *
 * @param outputs by port; what is left open is no {@link Sent.Messages}
 * @param left where the left side is afterwards, in words
 * @param right where the right side may be afterwards, each in words
 * @param error whether the left side sends nothing because its run ends in an error
 */
public record Moment(
        Letter input, Map<String, Sent> outputs, String left, List<String> right, boolean error) {
    public Moment {
        outputs = java.util.Collections.unmodifiableMap(new LinkedHashMap<>(outputs));
        right = List.copyOf(right);
    }

    /** A moment without an error. */
    public Moment(Letter input, Map<String, Sent> outputs, String left, List<String> right) {
        this(input, outputs, left, right, false);
    }
}

package arcomat.analysis.smt;

import arcomat.model.Expression;
import arcomat.semantics.expression.PartialEvaluation;

import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * What is left of expressions when a part of a letter is known. It is computed once for all letters
 * that agree on the ports which an expression reads: these are few, where letters are many.
 */
final class Remainders {
    /**
     * @param known what is left, by what is known of the ports
     */
    private record Rest(Reading reading, Map<Object, Expression> known) {}

    /** Expressions are met again as the same objects; to compare them would take longer. */
    private final Map<Expression, Rest> rests = new IdentityHashMap<>();

    Expression of(Expression expression, PartialEvaluation letter) {
        Rest rest =
                rests.computeIfAbsent(
                        expression, each -> new Rest(Reading.of(List.of(each)), new HashMap<>()));
        return rest.known.computeIfAbsent(
                rest.reading.knowledge(letter), known -> letter.of(expression));
    }
}

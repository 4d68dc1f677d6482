package arcomat.analysis.smt;

import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.semantics.expression.PartialEvaluation;

import java.util.ArrayList;
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
    private record Reading(List<String> ports, Map<Object, Expression> known) {
        static Reading of(Expression expression) {
            List<String> ports = expression.ports().stream().map(Port::name).distinct().toList();
            return new Reading(ports, new HashMap<>());
        }

        Object knowledge(PartialEvaluation letter) {
            if (ports.size() == 1) {
                return letter.knowledge(ports.get(0));
            }
            List<Object> all = new ArrayList<>(ports.size());
            ports.forEach(port -> all.add(letter.knowledge(port)));
            return all;
        }
    }

    /** Expressions are met again as the same objects; to compare them would take longer. */
    private final Map<Expression, Reading> readings = new IdentityHashMap<>();

    Expression of(Expression expression, PartialEvaluation letter) {
        Reading reading = readings.computeIfAbsent(expression, Reading::of);
        return reading.known.computeIfAbsent(
                reading.knowledge(letter), known -> letter.of(expression));
    }
}

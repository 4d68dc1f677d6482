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
     * What expressions read of a letter.
     *
     * @param ports by name, each once
     */
    record Reading(List<String> ports) {
        Reading {
            ports = List.copyOf(ports);
        }

        static Reading of(List<Expression> expressions) {
            return new Reading(
                    expressions.stream()
                            .flatMap(each -> each.ports().stream())
                            .map(Port::name)
                            .distinct()
                            .toList());
        }

        /**
         * What is known of these ports: of letters for which it is equal, the same is left open.
         */
        Object knowledge(PartialEvaluation letter) {
            if (ports.size() == 1) {
                return letter.knowledge(ports.get(0));
            }
            List<Object> all = new ArrayList<>(ports.size());
            ports.forEach(port -> all.add(letter.knowledge(port)));
            return all;
        }
    }

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

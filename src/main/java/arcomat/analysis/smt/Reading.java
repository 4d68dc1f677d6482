package arcomat.analysis.smt;

import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.semantics.expression.PartialEvaluation;

import java.util.ArrayList;
import java.util.List;

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

    /** What is known of these ports: of letters for which it is equal, the same is left open. */
    Object knowledge(PartialEvaluation letter) {
        if (ports.size() == 1) {
            return letter.knowledge(ports.get(0));
        }
        List<Object> all = new ArrayList<>(ports.size());
        ports.forEach(port -> all.add(letter.knowledge(port)));
        return all;
    }
}

package arcomat.analysis.coupling;

import arcomat.model.Expression;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.UnaryOperator;

/**
 * One way to answer a letter in a state: a transition, or the completion. Expressions read inputs,
 * and variables as if they were ports.
 *
 * @param when it happens
 * @param sends by the name of the output port
 * @param target the state after it, or {@link #CHAOS}
 * @param after the variables after it, by the names of their ports; those that it leaves alone are
 *     left out
 * @param name for messages
 */
record PossibleStep(
        Expression when,
        Map<String, Emitted> sends,
        int target,
        Map<String, Expression> after,
        String name) {
    static final int CHAOS = -1;

    PossibleStep {
        sends = Collections.unmodifiableMap(new LinkedHashMap<>(sends));
        after = Collections.unmodifiableMap(new LinkedHashMap<>(after));
    }

    /** The same with a letter of which something is known. */
    PossibleStep with(UnaryOperator<Expression> rest) {
        Map<String, Emitted> otherSends = new LinkedHashMap<>();
        sends.forEach((port, sent) -> otherSends.put(port, sent.with(rest)));
        Map<String, Expression> otherAfter = new LinkedHashMap<>();
        after.forEach((port, value) -> otherAfter.put(port, rest.apply(value)));
        return new PossibleStep(rest.apply(when), otherSends, target, otherAfter, name);
    }

    Emitted sent(Port port) {
        return Objects.requireNonNull(sends.get(port.name()));
    }

    /** All that it reads. */
    List<Expression> expressions() {
        List<Expression> all = new ArrayList<>(List.of(when));
        sends.values().forEach(sent -> sent.message().ifPresent(all::add));
        all.addAll(after.values());
        return all;
    }
}

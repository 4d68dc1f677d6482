package arcomat.check.behaviour.action;

import arcomat.symbols.expressions.PortSymbol;

import java.util.HashSet;
import java.util.Set;

/**
 * What the value of an expression tells of messages.
 *
 * @param always the ports without whose message it has no value
 * @param whenTrue the ports that have a message where it is true
 * @param whenFalse the ports that have a message where it is false
 */
record Presence(Set<PortSymbol> always, Set<PortSymbol> whenTrue, Set<PortSymbol> whenFalse) {
    static final Presence NONE = new Presence(Set.of(), Set.of(), Set.of());

    Presence {
        always = Set.copyOf(always);
        whenTrue = Set.copyOf(whenTrue);
        whenFalse = Set.copyOf(whenFalse);
    }

    /** Of what has a value only with all these messages. */
    static Presence of(Set<PortSymbol> ports) {
        return new Presence(ports, ports, ports);
    }

    Presence negated() {
        return new Presence(always, whenFalse, whenTrue);
    }

    /** Of a conjunction: one part that is false is enough. */
    Presence and(Presence other) {
        return new Presence(
                common(always, other.always),
                all(whenTrue, other.whenTrue),
                common(whenFalse, other.whenFalse));
    }

    Presence or(Presence other) {
        return negated().and(other.negated()).negated();
    }

    /** Of what is the one or the other. */
    Presence either(Presence other) {
        return new Presence(
                common(always, other.always),
                common(whenTrue, other.whenTrue),
                common(whenFalse, other.whenFalse));
    }

    static Set<PortSymbol> all(Set<PortSymbol> some, Set<PortSymbol> more) {
        Set<PortSymbol> all = new HashSet<>(some);
        all.addAll(more);
        return all;
    }

    private static Set<PortSymbol> common(Set<PortSymbol> some, Set<PortSymbol> others) {
        Set<PortSymbol> common = new HashSet<>(some);
        common.retainAll(others);
        return common;
    }
}

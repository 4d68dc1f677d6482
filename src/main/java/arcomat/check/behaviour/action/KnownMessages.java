package arcomat.check.behaviour.action;

import arcomat.symbols.expressions.PortSymbol;

import java.util.HashSet;
import java.util.Set;

/**
 * The messages that are known to be there by the value of an expression.
 *
 * @param always the ports without whose message it has no value
 * @param whenTrue the ports that have a message where it is true
 * @param whenFalse the ports that have a message where it is false
 */
record KnownMessages(Set<PortSymbol> always, Set<PortSymbol> whenTrue, Set<PortSymbol> whenFalse) {
    static final KnownMessages NONE = new KnownMessages(Set.of(), Set.of(), Set.of());

    KnownMessages {
        always = Set.copyOf(always);
        whenTrue = Set.copyOf(whenTrue);
        whenFalse = Set.copyOf(whenFalse);
    }

    /** Of what has a value only with all these messages. */
    static KnownMessages of(Set<PortSymbol> ports) {
        return new KnownMessages(ports, ports, ports);
    }

    KnownMessages negated() {
        return new KnownMessages(always, whenFalse, whenTrue);
    }

    /** Of a conjunction: one part that is false is enough. */
    KnownMessages and(KnownMessages other) {
        return new KnownMessages(
                common(always, other.always),
                all(whenTrue, other.whenTrue),
                common(whenFalse, other.whenFalse));
    }

    KnownMessages or(KnownMessages other) {
        return negated().and(other.negated()).negated();
    }

    /** Of what is the one or the other. */
    KnownMessages either(KnownMessages other) {
        return new KnownMessages(
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

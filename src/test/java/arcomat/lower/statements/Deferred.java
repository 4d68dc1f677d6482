package arcomat.lower.statements;

import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

/**
 * A value that is computed where it is needed.
 *
 * @param reads the ports that it reads
 * @param isDefined whether there is what it needs; perhaps a condition in it has to be looked at
 * @param value where it is defined
 */
record Deferred(Set<String> reads, BooleanSupplier isDefined, Supplier<Object> value) {

    static Deferred of(Object value) {
        return new Deferred(Set.of(), () -> true, () -> value);
    }

    /** The third truth value is empty. */
    Optional<Boolean> truth() {
        return isDefined.getAsBoolean() ? Optional.of((Boolean) value.get()) : Optional.empty();
    }

    int number() {
        return (Integer) value.get();
    }
}

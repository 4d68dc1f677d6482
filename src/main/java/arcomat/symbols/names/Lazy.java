package arcomat.symbols.names;

import org.jspecify.annotations.Nullable;

import java.util.Objects;
import java.util.function.Supplier;

/** A value computed at its first use; every reader sees the same object. */
public final class Lazy<T> implements Supplier<T> {
    private final Supplier<? extends T> computation;
    private volatile @Nullable T value;

    public Lazy(Supplier<? extends T> computation) {
        this.computation = computation;
    }

    @Override
    public T get() {
        T result = value;
        return result == null ? publish(Objects.requireNonNull(computation.get())) : result;
    }

    /** Two threads may compute; the first result stays. */
    private synchronized T publish(T candidate) {
        if (value == null) {
            value = candidate;
        }
        return value;
    }
}

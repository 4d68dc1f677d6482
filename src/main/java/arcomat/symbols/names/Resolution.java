package arcomat.symbols.names;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** The outcome of looking up a name. */
public sealed interface Resolution<T> {

    /** The thing, if exactly one has that name. */
    default Optional<T> found() {
        return Optional.empty();
    }

    /** What could be meant; empty unless ambiguous. */
    default List<T> candidates() {
        return List.of();
    }

    <U> Resolution<U> map(Function<? super T, ? extends U> function);

    /** Exactly one thing has that name. */
    record Found<T>(T value) implements Resolution<T> {
        @Override
        public Optional<T> found() {
            return Optional.of(value);
        }

        @Override
        public <U> Resolution<U> map(Function<? super T, ? extends U> function) {
            return new Found<>(function.apply(value));
        }
    }

    /** Nothing has that name: to be reported where the name stands. */
    record Unknown<T>() implements Resolution<T> {
        @Override
        public <U> Resolution<U> map(Function<? super T, ? extends U> function) {
            return unknown();
        }
    }

    /** Several things could be meant: to be reported where the name stands. */
    record Ambiguous<T>(List<T> candidates) implements Resolution<T> {
        public Ambiguous {
            candidates = List.copyOf(candidates);
        }

        @Override
        public <U> Resolution<U> map(Function<? super T, ? extends U> function) {
            return new Ambiguous<>(candidates.stream().<U>map(function).toList());
        }
    }

    /**
     * Not to be reported here: the file that should define the name did not parse, or the cause is
     * reported elsewhere (an import that leads nowhere, an unknown component).
     */
    record Excused<T>() implements Resolution<T> {
        @Override
        public <U> Resolution<U> map(Function<? super T, ? extends U> function) {
            return excused();
        }
    }

    static <T> Resolution<T> of(List<T> candidates) {
        return switch (candidates.size()) {
            case 0 -> unknown();
            case 1 -> new Found<>(candidates.get(0));
            default -> new Ambiguous<>(candidates);
        };
    }

    /** Of what has a name of its own or none. */
    static <T> Resolution<T> of(Optional<T> found) {
        return found.<Resolution<T>>map(Found::new).orElseGet(Resolution::unknown);
    }

    static <T> Resolution<T> excused() {
        return new Excused<>();
    }

    static <T> Resolution<T> unknown() {
        return new Unknown<>();
    }

    default boolean isFound() {
        return this instanceof Found<T>;
    }

    default boolean isUnknown() {
        return this instanceof Unknown<T>;
    }

    default boolean isExcused() {
        return this instanceof Excused<T>;
    }

    default boolean isAmbiguous() {
        return this instanceof Ambiguous<T>;
    }
}

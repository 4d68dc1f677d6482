package arcomat.symbols.names;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** The outcome of looking up a name. */
public sealed interface Resolution<T> {

    /** Exactly one thing has that name. */
    record Found<T>(T value) implements Resolution<T> {}

    /** Nothing has that name: to be reported where the name stands. */
    record Unknown<T>() implements Resolution<T> {}

    /** Several things could be meant: to be reported where the name stands. */
    record Ambiguous<T>(List<T> candidates) implements Resolution<T> {
        public Ambiguous {
            candidates = List.copyOf(candidates);
        }
    }

    /**
     * Not to be reported here: the file that should define the name did not parse, or the cause is
     * reported elsewhere (an import that leads nowhere, an unknown component).
     */
    record Excused<T>() implements Resolution<T> {}

    static <T> Resolution<T> of(List<T> candidates) {
        return switch (candidates.size()) {
            case 0 -> new Unknown<>();
            case 1 -> new Found<>(candidates.get(0));
            default -> new Ambiguous<>(candidates);
        };
    }

    static <T> Resolution<T> excused() {
        return new Excused<>();
    }

    static <T> Resolution<T> unknown() {
        return new Unknown<>();
    }

    default Optional<T> found() {
        return this instanceof Found<T> found ? Optional.of(found.value()) : Optional.empty();
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

    /** What could be meant; empty unless ambiguous. */
    default List<T> candidates() {
        return List.of();
    }

    default <U> Resolution<U> map(Function<? super T, ? extends U> function) {
        if (this instanceof Found<T> found) {
            return new Found<>(function.apply(found.value()));
        }
        if (this instanceof Ambiguous<T> ambiguous) {
            return new Ambiguous<>(
                    ambiguous.candidates().stream().<U>map(function::apply).toList());
        }
        return isUnknown() ? unknown() : excused();
    }
}

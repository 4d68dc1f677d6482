package arcomat.live.browser;

import org.jspecify.annotations.Nullable;

/** Casts as Java does; an error does not say the classes' names, which would all come along. */
public final class Casts {
    private Casts() {}

    /** In place of {@link Class#cast}, where the compiler for browsers puts it. */
    public static @Nullable Object cast(Class<?> type, @Nullable Object thing) {
        if (thing == null || type.isInstance(thing)) {
            return thing;
        }
        throw new ClassCastException();
    }
}

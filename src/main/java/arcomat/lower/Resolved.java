package arcomat.lower;

import arcomat.symbols.ComponentReference;
import arcomat.symbols.ComponentSymbol;
import arcomat.symbols.Resolution;

/** Takes what the checks guarantee. */
final class Resolved {
    private Resolved() {}

    static <T> T get(Resolution<T> resolution, Object what) {
        return resolution
                .found()
                .orElseThrow(() -> new IllegalStateException("unresolved: " + what));
    }

    static ComponentSymbol component(ComponentReference reference) {
        return get(reference.resolution(), reference.name());
    }
}

package arcomat.lower;

import arcomat.symbols.names.Resolution;

/** Takes what the checks guarantee. */
final class Resolved {
    private Resolved() {}

    static <T> T get(Resolution<T> resolution, Object what) {
        return resolution
                .found()
                .orElseThrow(() -> new IllegalStateException("unresolved: " + what));
    }
}

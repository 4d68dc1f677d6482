package arcomat.pipeline.check;

import java.util.Optional;

/**
 * What came of a task about models.
 *
 * @param check findings about the models; errors keep it from being done
 * @param value empty exactly where there are errors
 */
public record CheckedAnswer<T>(CheckResult check, Optional<T> value) {
    /** Of models that can be used. */
    public static <T> CheckedAnswer<T> of(CheckResult check, T value) {
        return new CheckedAnswer<>(check, Optional.of(value));
    }

    /** Of models that cannot. */
    public static <T> CheckedAnswer<T> refused(CheckResult check) {
        return new CheckedAnswer<>(check, Optional.empty());
    }
}

package arcomat.check;

import arcomat.source.Severity;

import java.util.Optional;

/**
 * The name of a context condition and how bad it is to break it.
 *
 * @param code {@code ARC} and four digits, used by one law only
 * @param inRequirements empty where a requirements model may break the law
 */
public record Law(String code, Optional<Severity> inRequirements, Severity inExecutable) {

    public static Law error(String code) {
        return new Law(code, Optional.of(Severity.ERROR), Severity.ERROR);
    }

    public static Law warning(String code) {
        return new Law(code, Optional.of(Severity.WARNING), Severity.WARNING);
    }

    /** An error where code is to be generated; not reported for requirements. */
    public static Law executableError(String code) {
        return new Law(code, Optional.empty(), Severity.ERROR);
    }

    /** A warning for requirements, an error where code is to be generated. */
    public static Law warningThenError(String code) {
        return new Law(code, Optional.of(Severity.WARNING), Severity.ERROR);
    }

    /** Empty where the law does not hold in a profile. */
    public Optional<Severity> severity(Profile profile) {
        return profile == Profile.EXECUTABLE ? Optional.of(inExecutable) : inRequirements;
    }
}

package arcomat.check.law;

import arcomat.source.Severity;

import java.util.Optional;

/**
 * A context condition: its name, how bad it is to break it, and who looks whether it is broken.
 *
 * @param code {@code ARC} and four digits, used by one law only; other capital letters in those of
 *     guests
 * @param inRequirements empty where a requirements model may break the law
 * @param needs what has to be known of a file, so that a finding would not vanish with its gaps
 */
public record Law(
        String code,
        Optional<Severity> inRequirements,
        Severity inExecutable,
        Needs needs,
        Check check) {

    /** What a law looks at beyond the place where it is broken. */
    public enum Needs {
        /** What is wrong stays wrong, whatever else there is. */
        NOTHING,
        /** It asks for something by a name, or by what that is. */
        NAMES,
        /** It asks for what has to be there, under whatever name. */
        ALL
    }

    public static Law error(String code, Check check) {
        return new Law(code, Optional.of(Severity.ERROR), Severity.ERROR, Needs.NOTHING, check);
    }

    public static Law warning(String code, Check check) {
        return new Law(code, Optional.of(Severity.WARNING), Severity.WARNING, Needs.NOTHING, check);
    }

    /** An error where code is to be generated; not reported for requirements. */
    public static Law executableError(String code, Check check) {
        return new Law(code, Optional.empty(), Severity.ERROR, Needs.NOTHING, check);
    }

    /** A warning where code is to be generated; not reported for requirements. */
    public static Law executableWarning(String code, Check check) {
        return new Law(code, Optional.empty(), Severity.WARNING, Needs.NOTHING, check);
    }

    /** A warning for requirements, an error where code is to be generated. */
    public static Law warningThenError(String code, Check check) {
        return new Law(code, Optional.of(Severity.WARNING), Severity.ERROR, Needs.NOTHING, check);
    }

    /** The same law, which needs to know more. */
    public Law needing(Needs more) {
        return new Law(code, inRequirements, inExecutable, more, check);
    }

    /** Empty where the law does not hold in a profile. */
    public Optional<Severity> severity(Profile profile) {
        return profile == Profile.EXECUTABLE ? Optional.of(inExecutable) : inRequirements;
    }
}

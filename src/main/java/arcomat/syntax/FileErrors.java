package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

/** Findings about a file as a whole. */
final class FileErrors {
    private FileErrors() {}

    /**
     * @param place where the definition is missed
     */
    static Diagnostic nothingDefined(SourceFile file, int place) {
        Language language = Language.of(file);
        return Diagnostic.error(
                Codes.EMPTY,
                file.span(place, place),
                "This file defines nothing. Write %s, such as '%s', or delete the file."
                        .formatted(language.definition(), language.example()));
    }
}

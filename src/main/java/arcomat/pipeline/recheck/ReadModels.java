package arcomat.pipeline.recheck;

import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parsed;

import java.util.Optional;
import java.util.Set;

/** Texts that somebody works on, and what could be read of them. */
public interface ReadModels {
    /** All files. */
    Set<String> paths();

    /** A file, or nothing where there is none of that path or it cannot be read. */
    Optional<SourceFile> source(String path);

    /** What came of reading the text as it is now. */
    Optional<Parsed> parsed(String path);

    /** What names mean now, also in what could be read of files with syntax errors. */
    Workspace workspace();
}

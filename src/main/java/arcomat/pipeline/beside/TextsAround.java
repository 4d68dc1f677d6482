package arcomat.pipeline.beside;

import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.SourceFile;

import java.nio.file.Path;
import java.util.Collection;
import java.util.Optional;

/** What a text beside models may refer to. */
public interface TextsAround {
    /** A file as it is now, on the screen or on the disk; nothing where there is none. */
    Optional<SourceFile> text(Path file);

    /** The models of a model root, if it is known here. */
    Optional<OpenModels> models(Path root);

    /** The models of all model roots that are known here. */
    Collection<OpenModels> all();
}

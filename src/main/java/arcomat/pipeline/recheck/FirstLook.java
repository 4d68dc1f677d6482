package arcomat.pipeline.recheck;

import arcomat.check.Checks;
import arcomat.guest.host.Guests;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * What is to be said of one file before all others of its root have been read: what a check of this
 * file alone says, which reads what the file refers to. It is to be followed by a check of all.
 *
 * @param models as far as they have been read
 * @param path of the file; no other one is checked
 */
public record FirstLook(OpenModels models, String path) {
    /**
     * Reads what the file refers to, over some steps, and checks it.
     *
     * @param root the folder of the models, absolute
     * @param text of the file, whose path starts there
     * @param guests who bring laws and behaviour languages
     * @param libraries models of others that the file may refer to
     * @return nothing where the file's package does not say where others are to be looked for
     */
    public static Optional<FirstLook> at(
            Path root, SourceFile text, Guests guests, LibraryModels libraries) {
        String path = text.path();
        return new Reach(root, guests, libraries)
                .of(text)
                .map(models -> new FirstLook(models.check(path::equals, () -> {}), path));
    }

    /** Whether a suppression is needless is not known before all laws have been asked. */
    public List<Diagnostic> findings() {
        return models.findings(path).stream()
                .filter(each -> !Checks.isUnusedSuppression(each))
                .toList();
    }
}

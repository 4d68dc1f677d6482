package arcomat.pipeline.picture;

import arcomat.pipeline.PathNames;
import arcomat.source.Span;

import java.net.URI;
import java.nio.file.Path;
import java.util.Optional;

/** Links from pictures to the lines of models, relative, so that a project can be moved. */
public final class SourceLinks {
    private final PathNames names;
    private final Path folder;

    /**
     * @param out the folder of the pictures, as the user wrote it
     */
    public SourceLinks(PathNames names, String out) {
        this.names = names;
        this.folder = names.resolve(out).toAbsolutePath().normalize();
    }

    /** Empty for what is in no file, such as the model library. */
    public Optional<String> of(Span place) {
        Path file = names.resolve(place.file().path()).toAbsolutePath().normalize();
        if (!file.toFile().isFile() || !folder.getRoot().equals(file.getRoot())) {
            return Optional.empty();
        }
        String path = folder.relativize(file).toString().replace('\\', '/');
        String address = URI.create("").resolve(encoded(path)).toString();
        return Optional.of(address + "#L" + place.startPosition().line());
    }

    private static String encoded(String path) {
        try {
            return new URI(null, null, path, null).toASCIIString();
        } catch (java.net.URISyntaxException e) {
            throw new AssertionError(e);
        }
    }
}

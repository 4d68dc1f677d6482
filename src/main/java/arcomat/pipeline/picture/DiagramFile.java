package arcomat.pipeline.picture;

import arcomat.diagram.Graph;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.AtomicFile;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;

/** One picture in a file of its own; its name says the format. */
public final class DiagramFile {
    private DiagramFile() {}

    /** Before long work whose result could not be written. */
    public static void requireKnown(Optional<String> file) throws WrongUse {
        if (file.isPresent()) {
            format(file.get());
        }
    }

    /**
     * Writes a picture; folders on the way are made.
     *
     * @param file as the user wrote it
     * @throws WrongUse where its name says no format, or it cannot be written
     */
    public static void write(String file, Graph graph, PathNames names) throws WrongUse {
        Path folder = names.resolve(file).toAbsolutePath().normalize().getParent();
        byte[] content =
                format(file)
                        .content(
                                graph,
                                new SourceLinks(names, Objects.requireNonNull(folder).toString())
                                        ::of);
        AtomicFile.write(file, content, names);
    }

    private static PictureFormat format(String file) throws WrongUse {
        return Arrays.stream(PictureFormat.values())
                .filter(format -> file.endsWith("." + format))
                .findFirst()
                .orElseThrow(
                        () ->
                                new WrongUse(
                                        "'%s' says no format; pictures end in .svg, .png or .dot",
                                        file));
    }
}

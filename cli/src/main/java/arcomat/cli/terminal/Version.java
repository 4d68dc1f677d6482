package arcomat.cli.terminal;

import picocli.CommandLine;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.FileVisitor;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Objects;

/** The version that the build wrote into the tool. */
public final class Version implements CommandLine.IVersionProvider {
    private static final String NUMBER = "/arcomat-version.txt";

    /** As releases count. */
    public static String number() {
        try (InputStream in = Version.class.getResourceAsStream(NUMBER)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).strip();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Of this very build, also where the number stays the same while somebody works on the tool.
     */
    public static String identity() {
        try {
            URI classes = Version.class.getProtectionDomain().getCodeSource().getLocation().toURI();
            URI number = Version.class.getResource(NUMBER).toURI();
            StringBuilder identity = new StringBuilder(number());
            append(Path.of(classes), identity);
            if (number.getScheme().equals("file")) {
                append(Objects.requireNonNull(Path.of(number).getParent()), identity);
            }
            return identity.toString();
        } catch (IOException | URISyntaxException | RuntimeException unknown) {
            return number();
        }
    }

    /** A jar, or every file of a folder: one that changes leaves the time of the folder alone. */
    private static void append(Path place, StringBuilder identity) throws IOException {
        FileVisitor<Path> visitor =
                new SimpleFileVisitor<>() {
                    @Override
                    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                        identity.append('\n').append(file);
                        identity.append(' ').append(attributes.size());
                        identity.append(' ').append(attributes.lastModifiedTime());
                        return FileVisitResult.CONTINUE;
                    }
                };
        Files.walkFileTree(place, visitor);
    }

    @Override
    public String[] getVersion() {
        return new String[] {"arcomat " + number()};
    }
}

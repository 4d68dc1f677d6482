package arcomat.cli;

import picocli.CommandLine;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;

/** The version that the build wrote into the tool. */
final class Version implements CommandLine.IVersionProvider {
    static String number() {
        try (InputStream in = Version.class.getResourceAsStream("/arcomat-version.txt")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).strip();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Of this very build, also where the number stays the same while somebody works on the tool.
     */
    static String identity() {
        try {
            URI place = Version.class.getProtectionDomain().getCodeSource().getLocation().toURI();
            FileTime time = Files.getLastModifiedTime(Path.of(place));
            return number() + " " + place + " " + time;
        } catch (IOException | URISyntaxException | RuntimeException unknown) {
            return number();
        }
    }

    @Override
    public String[] getVersion() {
        return new String[] {"arcomat " + number()};
    }
}

package arcomat.cli;

import picocli.CommandLine;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** The version that the build wrote into the tool. */
final class Version implements CommandLine.IVersionProvider {
    static String number() {
        try (InputStream in = Version.class.getResourceAsStream("/arcomat-version.txt")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).strip();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public String[] getVersion() {
        return new String[] {"arcomat " + number()};
    }
}

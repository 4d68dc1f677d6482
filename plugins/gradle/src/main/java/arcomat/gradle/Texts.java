package arcomat.gradle;

import org.gradle.api.file.RegularFileProperty;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;

/** Reads and writes small texts. */
final class Texts {
    private Texts() {}

    static String read(File file) {
        try {
            return Files.readString(file.toPath());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static void write(RegularFileProperty file, String text) {
        try {
            Files.writeString(file.get().getAsFile().toPath(), text);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}

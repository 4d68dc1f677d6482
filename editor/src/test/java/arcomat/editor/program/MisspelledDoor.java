package arcomat.editor.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Two models in {@code p}, of which one is misspelled and badly laid out. */
record MisspelledDoor(Path door, Path house) {
    private static final Path FILES = Path.of("editor/src/test/resources/misspelled/p");

    /** Copies them to a folder, below which they are in their package. */
    static MisspelledDoor in(Path folder) throws IOException {
        Path models = Files.createDirectories(folder.resolve("p"));
        return new MisspelledDoor(copy("Door.arc", models), copy("House.arc", models));
    }

    private static Path copy(String name, Path folder) throws IOException {
        return Files.copy(FILES.resolve(name), folder.resolve(name));
    }

    /** With a port that is called {@code pushed}, in both. */
    void isMendedLaidOutAndRenamed() throws IOException {
        assertThat(door)
                .hasContent(
                        Files.readString(FILES.resolve("Door.arc"))
                                .replace("state   closed ;", "        state closed;")
                                .replace("pressed", "pushed")
                                .replace("presed", "pushed"));
        assertThat(house)
                .hasContent(
                        Files.readString(FILES.resolve("House.arc")).replace("pressed", "pushed"));
    }
}

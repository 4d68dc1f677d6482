package arcomat.editor.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The files in {@code editors/kate}, by the command that colours as Kate does: it knows the
 * languages by the names of files, and takes words for what they are.
 */
@Tag("editor")
class KateTest {
    private static final Path FILES = Path.of("editors/kate");

    /** Of version 6 of the libraries, and of version 5. */
    private static final List<String> PROGRAMS =
            List.of("ksyntaxhighlighter6", "kate-syntax-highlighter");

    private static final long MINUTES = 1;

    @TempDir private Path folder;
    private String program = "";

    @BeforeEach
    void install() throws IOException {
        Optional<String> there = PROGRAMS.stream().filter(Installed::isThere).findFirst();
        assumeTrue(there.isPresent(), "Kate's colours (kate-syntax-highlighter) are not installed");
        program = there.get();
        Path syntax = Files.createDirectories(folder.resolve("org.kde.syntax-highlighting/syntax"));
        try (Stream<Path> files = Files.list(FILES)) {
            for (Path file : files.toList()) {
                Files.copy(file, syntax.resolve(file.getFileName()));
            }
        }
    }

    @Test
    void theLanguagesAreKnown() throws Exception {
        assertThat(run("--list").lines())
                .contains("Arcomat", "Arcomat World", "Arcomat Campaign", "Arcomat Script");
    }

    @Test
    void modelsAreColoured() throws Exception {
        String page =
                coloured(
                        "Door.arc",
                        """
                        package p;
                        /* waits */
                        <<deploy>> component Door {
                            port in Boolean pressed;
                            automaton { state open; initial open / {lamp = "on", count = 12}; }
                        }
                        """);
        assertThat(style(page, "component"))
                .isEqualTo(style(page, "automaton"))
                .isNotEqualTo(style(page, "Door"))
                .isNotEqualTo(style(page, "/* waits */"));
        assertThat(style(page, "Door")).isEqualTo(style(page, "Boolean"));
        assertThat(style(page, "\"on\"")).isNotEqualTo(style(page, "12"));
    }

    @Test
    void worldsAreColoured() throws Exception {
        String page =
                coloured("a.world", "floor 900 800 # mm\nkind car\n  wheels A B\nnoise wheels 3\n");
        assertThat(style(page, "floor")).isEqualTo(style(page, "noise"));
        assertThat(style(page, "floor")).isNotEqualTo(style(page, "# mm"));
        assertThat(style(page, "900")).isEqualTo(style(page, "800"));
        assertThat(page).contains("car\n").doesNotContain(">car<");
    }

    @Test
    void campaignsAreColoured() throws Exception {
        String page = coloured("a.campaign", "world a.world\nrequire collision below 0.01 at 95\n");
        assertThat(style(page, "world")).isEqualTo(style(page, "require"));
        assertThat(style(page, "below")).isEqualTo(style(page, "at"));
        assertThat(style(page, "collision")).isNotEqualTo(style(page, "below"));
    }

    @Test
    void scriptsAreColoured() throws Exception {
        String page = coloured("a.script", "0 S1 100\n100 button ENTER down\n200 end\n");
        assertThat(style(page, "button")).isEqualTo(style(page, "end"));
        assertThat(style(page, "S1")).isEqualTo(style(page, "ENTER"));
    }

    private String coloured(String name, String text) throws Exception {
        return run(Files.writeString(folder.resolve(name), text).toString());
    }

    /** That of the first time that some words stand in a page alone. */
    private static String style(String page, String words) {
        String written = words.replace("\"", "&quot;");
        Matcher span =
                Pattern.compile("<span style=\"([^\"]*)\">" + Pattern.quote(written) + "</span>")
                        .matcher(page);
        assertThat(span.find()).as(words + " in " + page).isTrue();
        return span.group(1);
    }

    private String run(String word) throws Exception {
        Path output = folder.resolve("output.html");
        ProcessBuilder builder =
                new ProcessBuilder(program, word)
                        .redirectErrorStream(true)
                        .redirectOutput(output.toFile());
        builder.environment().put("XDG_DATA_HOME", folder.toString());
        Process process = builder.start();
        assertThat(process.waitFor(MINUTES, TimeUnit.MINUTES)).isTrue();
        return Files.readString(output);
    }
}

package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.Cli;
import arcomat.cli.Console;
import arcomat.report.Style;

import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringReader;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The README and the pages about platform components, builds, the gate and analyses tell the truth:
 * their models are written to files, their commands are run in the order of the page, and the
 * output has to be what the page shows. A line {@code ...} stands for any lines.
 */
class ReadmeTest {
    @TempDir Path directory;

    private static Stream<Path> pages() throws IOException {
        try (Stream<Path> analyses = Files.list(Path.of("docs/analysis"))) {
            List<Path> pages = new ArrayList<>(analyses.sorted().toList());
            pages.add(Path.of("docs/ci.md"));
            pages.add(Path.of("docs/platform.md"));
            pages.add(Path.of("docs/gate.md"));
            pages.add(Path.of("README.md"));
            return pages.stream();
        }
    }

    @ParameterizedTest
    @MethodSource("pages")
    void showsWhatTheToolSays(Path page) throws IOException {
        copy(Path.of("models"), directory.resolve("models"));
        for (Fence fence : Fence.of(page)) {
            if (fence.language().equals("console")) {
                replay(fence);
            } else if (!fence.title().isEmpty()) {
                write(directory.resolve(fence.title()), fence.text());
            }
        }
    }

    @ParameterizedTest
    @MethodSource("pages")
    void namesOnlyFilesThatExist(Path page) throws IOException {
        var links = Pattern.compile("]\\(([^)#:]+)[^)]*\\)").matcher(Files.readString(page));
        while (links.find()) {
            assertThat(Path.of(links.group(1))).exists();
        }
    }

    private void replay(Fence session) {
        List<String> wanted = new ArrayList<>();
        String command = null;
        for (String line : session.body()) {
            if (line.startsWith("$ ")) {
                compare(command, wanted);
                command = line.substring(2);
                wanted = new ArrayList<>();
            } else {
                wanted.add(line);
            }
        }
        compare(command, wanted);
    }

    private void compare(String command, List<String> wanted) {
        if (command != null) {
            String actual = run(command);
            String text = String.join("\n", wanted).strip() + "\n";
            if (!pattern(text).matcher(actual).matches()) {
                assertThat(actual).as(command).isEqualTo(text);
            }
        }
    }

    private static Pattern pattern(String text) {
        StringBuilder regex = new StringBuilder();
        for (String line : text.lines().toList()) {
            regex.append(line.equals("...") ? "(.*\n)*" : Pattern.quote(line + "\n"));
        }
        return Pattern.compile(regex.toString());
    }

    private String run(String command) {
        String[] words = command.split(" +");
        assertThat(words[0]).isEqualTo("arcomat");
        StringWriter text = new StringWriter();
        Console console =
                new Console(
                        directory,
                        new PrintWriter(text),
                        new PrintWriter(Writer.nullWriter()), // progress depends on the machine
                        new BufferedReader(new StringReader("")),
                        Style.PLAIN,
                        false);
        Cli.run(Stream.of(words).skip(1).toArray(String[]::new), console);
        return text.toString().strip() + "\n";
    }

    private static void write(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }

    /** Copies texts; what a build of them has left is none of them. */
    private static void copy(Path source, Path target) throws IOException {
        try (Stream<Path> files = Files.walk(source)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Path path = source.relativize(file);
                if (!isBuilt(path)) {
                    write(target.resolve(path.toString()), Files.readString(file));
                }
            }
        }
    }

    private static boolean isBuilt(Path path) {
        for (Path name : path) {
            if (name.toString().equals("build") || name.toString().startsWith(".")) {
                return true;
            }
        }
        return false;
    }
}

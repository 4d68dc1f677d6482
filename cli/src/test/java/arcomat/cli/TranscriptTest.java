package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.Transcript.Section;
import arcomat.cli.terminal.Console;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;

/**
 * Replays every session of {@code src/test/resources/cli}. With {@code -Dtranscripts.update=true}
 * the files are rewritten to what the tool says now; read the difference before keeping it.
 */
class TranscriptTest {
    private static final Path FOLDER = Path.of("cli/src/test/resources/cli");
    private static final boolean UPDATE = Boolean.getBoolean("transcripts.update");
    private static final Pattern WORD = Pattern.compile("'([^']*)'|\"([^\"]*)\"|(\\S+)");

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> sessions() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.filter(f -> f.toString().endsWith(".txt")).sorted().toList().stream()
                    .map(f -> DynamicTest.dynamicTest(f.getFileName().toString(), () -> replay(f)));
        }
    }

    private static void replay(Path file) throws IOException {
        List<String> lines = Files.readAllLines(file);
        Path directory = Files.createTempDirectory("arcomat-session");
        try {
            Transcript actual = replay(Transcript.parse(lines), directory);
            if (UPDATE) {
                Files.writeString(file, actual.text());
            }
            assertThat(actual.text()).isEqualTo(String.join("\n", lines) + "\n");
        } finally {
            Folders.delete(directory);
        }
    }

    private static Transcript replay(Transcript wanted, Path directory) throws IOException {
        List<Section> sections = new ArrayList<>();
        StringBuilder typed = new StringBuilder();
        for (Section section : wanted.sections()) {
            prepare(section, directory);
            if (section.isTyped()) {
                typed.append(section.rest()).append('\n');
            }
            if (section.isCommand()) {
                sections.add(section.withBody(run(section.rest(), typed.toString(), directory)));
                typed.setLength(0);
            } else {
                sections.add(section);
            }
        }
        return new Transcript(sections);
    }

    private static void prepare(Section section, Path directory) throws IOException {
        if (section.kind().isEmpty()) {
            return;
        }
        String[] names = section.rest().split(" -> ");
        Path path = directory.resolve(names[0]);
        Files.createDirectories(path.getParent());
        String text = String.join("\n", section.body()) + "\n";
        switch (section.kind()) {
            case "file" -> Files.writeString(path, text);
            case "program" -> {
                Files.writeString(path, text);
                assertThat(path.toFile().setExecutable(true)).isTrue();
            }
            case "bytes" -> Files.write(path, HexFormat.of().parseHex(text.replaceAll("\\s", "")));
            case "link" -> Files.createSymbolicLink(path, Path.of(names[1]));
            case "folder" -> Files.createDirectories(path);
            default -> throw new IllegalArgumentException(section.head());
        }
    }

    private static List<String> run(String command, String typed, Path directory)
            throws IOException {
        List<String> words = words(command);
        List<String> arguments = words.subList(1, words.size());
        return switch (words.get(0)) {
            case "arcomat" -> arcomat(arguments, typed, directory);
            case "cat" -> Files.readAllLines(directory.resolve(arguments.get(0)));
            case "javac" -> compile(arguments, directory);
            case "ls" -> Folders.list(directory.resolve(arguments.get(0)));
            default -> throw new IllegalArgumentException(command);
        };
    }

    /** Compiles guests, which see what the tool's own tests see: {@code javac FILES -d FOLDER}. */
    private static List<String> compile(List<String> arguments, Path directory) {
        StringWriter out = new StringWriter();
        List<String> all =
                arguments.stream()
                        .map(word -> word.startsWith("-") ? word : directory.resolve(word) + "")
                        .toList();
        int status =
                ToolProvider.findFirst("javac")
                        .orElseThrow()
                        .run(
                                new PrintWriter(out),
                                new PrintWriter(out),
                                all.toArray(String[]::new));
        assertThat(status).as(out.toString()).isZero();
        return List.of();
    }

    private static List<String> arcomat(List<String> arguments, String typed, Path directory) {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        Console console =
                Console.quiet(
                        directory,
                        new PrintWriter(out),
                        new PrintWriter(err),
                        new BufferedReader(new StringReader(typed)));
        int status = Cli.run(arguments.toArray(String[]::new), console);
        List<String> lines = new ArrayList<>(out.toString().lines().toList());
        err.toString().lines().map(line -> "! " + line).forEach(lines::add);
        lines.add("= " + status);
        // No session may show where it ran, nor more of a failure than its message.
        lines.replaceAll(line -> line.replace(directory.toString(), "DIRECTORY"));
        assertThat(lines).noneMatch(line -> line.startsWith("! \tat "));
        return lines;
    }

    private static List<String> words(String command) {
        List<String> words = new ArrayList<>();
        Matcher matcher = WORD.matcher(command);
        while (matcher.find()) {
            words.add(
                    Arrays.asList(matcher.group(1), matcher.group(2), matcher.group(3)).stream()
                            .filter(g -> g != null)
                            .findFirst()
                            .orElseThrow());
        }
        return words;
    }
}

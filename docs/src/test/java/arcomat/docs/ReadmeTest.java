package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The README and every page of {@code docs} tell the truth: their models are written to files,
 * their commands are run in the order of the page, and the output has to be what the page shows. A
 * line {@code ...} stands for any lines. With {@code -Dtranscripts.update=true} pages are rewritten
 * to what the tool says now; read the difference before keeping it.
 */
class ReadmeTest {
    private static final boolean UPDATE = Boolean.getBoolean("transcripts.update");

    /** Its examples are one model, and have a test of their own. */
    private static final Path REFERENCE = Path.of("docs/language.md");

    private static final Path GUEST = Path.of("guests/statemachine");

    private static final Pattern LINK = Pattern.compile("]\\(([^)#:]+)(?:#[^)]*)?\\)");

    @TempDir Path directory;

    private static Stream<Path> pages() throws IOException {
        List<Path> pages = new ArrayList<>();
        try (Stream<Path> files = Files.walk(Path.of("docs"))) {
            files.filter(file -> file.toString().endsWith(".md")).sorted().forEach(pages::add);
        }
        pages.add(Path.of("README.md"));
        pages.add(Path.of("CONTRIBUTING.md"));
        pages.add(Path.of("models/coffee/README.md"));
        return pages.stream();
    }

    private static Stream<Path> replayed() throws IOException {
        return pages().filter(page -> !page.equals(REFERENCE));
    }

    @Tag("slow")
    @ParameterizedTest
    @MethodSource("replayed")
    void showsWhatTheToolSays(Path page) throws IOException {
        copy(Path.of("models"), directory.resolve("models"));
        // Only where it is compiled: a page that names no folder would find its models as well.
        if (Files.readString(page).contains("guests/statemachine/src/main")) {
            copy(GUEST, directory.resolve(GUEST.toString()));
        }
        Map<Fence, Session> news =
                new Replay(directory, BuildTasks.read(), hasMona()).run(Fence.of(page));
        if (UPDATE) {
            update(page, news);
        }
        news.forEach(
                (fence, session) ->
                        assertThat(text(session.lines()))
                                .as("%s, line %d", page, fence.line())
                                .isEqualTo(text(fence.body())));
    }

    private static String text(List<String> lines) {
        return String.join("\n", lines);
    }

    private static void update(Path page, Map<Fence, Session> news) throws IOException {
        List<String> lines = Files.readAllLines(page);
        news.keySet().stream()
                .sorted(Comparator.comparing(Fence::line).reversed())
                .forEach(fence -> replace(lines, fence.line(), news.get(fence).lines()));
        Files.write(page, lines);
    }

    /**
     * @param line of the first line in the block, from 1
     */
    private static void replace(List<String> page, int line, List<String> lines) {
        List<String> rest = page.subList(line - 1, page.size());
        List<String> block = rest.subList(0, rest.indexOf("```"));
        block.clear();
        block.addAll(lines);
    }

    @ParameterizedTest
    @MethodSource("pages")
    void namesOnlyFilesThatExist(Path page) throws IOException {
        var links = LINK.matcher(Files.readString(page));
        while (links.find()) {
            assertThat(page.resolveSibling(links.group(1))).exists();
        }
    }

    /** Code that is only indented would be seen by nobody. */
    @ParameterizedTest
    @MethodSource("pages")
    void hasFencesAroundAllBlocks(Path page) throws IOException {
        String text = Files.readString(page).replaceAll("(?ms)^ *```.*?^ *```$", "");
        assertThat(text.lines()).noneMatch(line -> line.matches("( {4,}|\t).*"));
    }

    private static boolean hasMona() {
        return Arrays.stream(System.getenv("PATH").split(File.pathSeparator))
                .anyMatch(folder -> Files.isExecutable(Path.of(folder, "mona")));
    }

    /** Copies texts; what a build of them has left is none of them. */
    private static void copy(Path source, Path target) throws IOException {
        try (Stream<Path> files = Files.walk(source)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Path path = source.relativize(file);
                if (!isBuilt(path)) {
                    Path copy = target.resolve(path.toString());
                    Files.createDirectories(copy.getParent());
                    Files.copy(file, copy);
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

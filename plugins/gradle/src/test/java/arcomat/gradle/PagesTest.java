package arcomat.gradle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The builds on the pages of {@code docs} work. A block {@code groovy build.gradle} begins a build
 * script, and {@code groovy onto build.gradle} goes on. What {@code $ gradle} is told on the page
 * is done; lines with {@code ./gradlew} name tasks and options that are there. Other files of the
 * page are in the project as well; a page without models gets those of a shop.
 */
@Tag("build")
class PagesTest {
    private static final Path DOCS = Path.of("../../docs");
    private static final Pattern BLOCK = Pattern.compile("(?ms)^```(\\w+) ?([^\n]*)\n(.*?)^```$");
    private static final Pattern DONE = Pattern.compile("(?m)^\\$ gradle (.*)\n((?:[^$`].*\n)*)");
    private static final Pattern NAMED = Pattern.compile("\\./gradlew ([^&>|#\n]*)");

    /** Tasks of the build that the pages belong to. */
    private static final Set<String> OF_ARCOMAT = Set.of("installDist", "publishToMavenLocal");

    @TempDir private Path folder;
    private ConsumerProject project;

    static List<Path> pages() throws IOException {
        List<Path> pages = new ArrayList<>();
        try (Stream<Path> files = Files.walk(DOCS)) {
            for (Path file : files.filter(f -> f.toString().endsWith(".md")).sorted().toList()) {
                if (Files.readString(file).contains("\n```groovy build.gradle\n")) {
                    pages.add(file);
                }
            }
        }
        return pages;
    }

    @ParameterizedTest
    @MethodSource("pages")
    void buildsWhatItSays(Path page) throws IOException {
        String text = Files.readString(page);
        List<MatchResult> blocks = BLOCK.matcher(text).results().toList();
        boolean models = blocks.stream().anyMatch(block -> block.group(1).equals("arc"));
        project = models ? ConsumerProject.empty(folder) : ConsumerProject.shop(folder);
        blocks.forEach(this::write);
        project.useToolOfThisBuild();

        DONE.matcher(text).results().forEach(this::run);
        for (MatchResult block : blocks) {
            if (!block.group(1).equals("console")) {
                NAMED.matcher(block.group(3)).results().forEach(this::find);
            }
        }
    }

    /** Lines that the page shows are among those printed. */
    private void run(MatchResult command) {
        List<String> shown = new ArrayList<>(command.group(2).lines().toList());
        shown.remove("...");
        assertThat(project.build(words(command)).getOutput().lines()).containsAll(shown);
    }

    private void find(MatchResult command) {
        if (!OF_ARCOMAT.contains(command.group(1).strip())) {
            List<String> words = new ArrayList<>(List.of(words(command)));
            words.add("--dry-run");
            assertThat(project.build(words.toArray(String[]::new)).getOutput()).contains("SKIPPED");
        }
    }

    private static String[] words(MatchResult command) {
        return command.group(1).strip().split(" +");
    }

    private void write(MatchResult block) {
        String title = block.group(2);
        if (title.startsWith("onto ")) {
            project.append(title.substring("onto ".length()), block.group(3));
        } else if (title.contains(".") && !title.contains(" ")) {
            project.write(title, block.group(3));
        }
    }
}

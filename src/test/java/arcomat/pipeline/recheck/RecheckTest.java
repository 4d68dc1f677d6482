package arcomat.pipeline.recheck;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckFiles;
import arcomat.pipeline.check.CheckResult;
import arcomat.source.Diagnostic;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * Each rule about what else a change touches, by one story. {@code >>> check PATHS} starts a step,
 * whose files follow as in other test data, {@code gone} where one is removed; then stands which
 * files are looked at again and what is found, which is also what a check without memory finds.
 */
class RecheckTest {
    private static final Path STORIES = Path.of("src/test/resources/recheck");

    @TempDir private Path folders;

    @TestFactory
    List<DynamicTest> looksAtWhatAChangeTouches() throws IOException {
        try (Stream<Path> stories = Files.list(STORIES)) {
            return stories.sorted()
                    .map(story -> DynamicTest.dynamicTest(name(story), () -> follow(story)))
                    .toList();
        }
    }

    private static String name(Path story) {
        return story.getFileName().toString().replace(".txt", "");
    }

    private void follow(Path story) throws IOException, WrongUse {
        Path folder = Files.createDirectory(folders.resolve(name(story)));
        Step step = null;
        for (String line : Files.readAllLines(story)) {
            if (line.startsWith(">>> check ")) {
                finish(step);
                step = new Step(folder, List.of(line.substring(10).split(" ")));
            } else if (step != null) {
                step.add(line);
            }
        }
        finish(step);
    }

    private static void finish(Step step) throws IOException, WrongUse {
        if (step != null) {
            step.finish();
        }
    }

    /** Files that change, and a check. */
    private static final class Step {
        private final Path folder;
        private final List<String> paths;
        private final List<String> lookedAt = new ArrayList<>();
        private final List<String> found = new ArrayList<>();
        private final StringBuilder text = new StringBuilder();
        private Path file;

        Step(Path folder, List<String> paths) {
            this.folder = folder;
            this.paths = paths;
        }

        void add(String line) throws IOException {
            if (line.startsWith("//// ")) {
                write();
                file = folder.resolve(line.substring(5));
            } else if (line.startsWith("looks at ")) {
                lookedAt.addAll(List.of(line.substring(9).split(" ")));
            } else if (line.startsWith("finds ")) {
                found.add(line.substring(6));
            } else {
                text.append(line).append('\n');
            }
        }

        void finish() throws IOException, WrongUse {
            write();
            Session session = Session.in(folder, Progress.NONE);
            CheckResult full = session.run(new CheckFiles(paths, false));
            Recheck again = session.run(new CheckAgain(paths, false, "state.json", "this tool"));
            assertThat(IncrementalCheckTest.text(again.result()))
                    .isEqualTo(IncrementalCheckTest.text(full));
            assertThat(again.checked()).containsExactlyElementsOf(lookedAt);
            assertThat(again.result().findings())
                    .extracting(Step::words)
                    .containsExactlyElementsOf(found);
        }

        private void write() throws IOException {
            if (file == null) {
                return;
            }
            String content = text.toString().strip();
            text.setLength(0);
            if (content.equals("gone")) {
                Files.delete(file);
            } else {
                Files.createDirectories(file.getParent());
                Files.writeString(file, content + "\n");
            }
        }

        private static String words(Diagnostic finding) {
            return finding.code() + " in " + finding.span().file().path();
        }
    }
}

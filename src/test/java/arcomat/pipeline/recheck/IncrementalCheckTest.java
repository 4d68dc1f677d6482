package arcomat.pipeline.recheck;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckFiles;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.file.FileFinder;
import arcomat.report.finding.CheckReport;
import arcomat.report.finding.FindingsJson;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Style;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;

/**
 * Whatever happens to the files of a folder, a check that remembers the last one finds what a check
 * without memory finds. The models are those that show what each law is about, thrown together.
 */
class IncrementalCheckTest {
    private static final int FILES = 30;
    private static final int ROUNDS = 25;

    @Tag("slow")
    @Property(tries = 4)
    void findsWhatAFullCheckFinds(@ForAll long seed) throws IOException {
        Path folder = Files.createTempDirectory("incremental");
        try {
            Random random = new Random(seed);
            EditedModels models = new EditedModels(folder, random);
            while (models.size() < FILES) {
                models.add();
            }
            Edited session =
                    new Edited(
                            folder,
                            random.nextBoolean(),
                            random.nextBoolean(),
                            random.nextBoolean());
            session.check("at first");
            for (int round = 0; round < ROUNDS; round++) {
                StringBuilder what = new StringBuilder();
                for (int edits = random.nextInt(4) == 0 ? 3 : 1; edits > 0; edits--) {
                    what.append(models.edit()).append("; ");
                }
                session.check(what.toString());
            }
        } finally {
            delete(folder);
        }
    }

    /**
     * @param library whether what is not named belongs to a library
     */
    private record Edited(Path folder, boolean executable, boolean byFile, boolean library) {
        void check(String after) throws IOException {
            List<String> libraries = byFile && library ? List.of(".") : List.of();
            Session session = Session.in(folder, Progress.NONE).with(libraries);
            List<String> paths = byFile ? files() : List.of(".");
            CheckResult full;
            Recheck again;
            try {
                full = session.run(new CheckFiles(paths, executable));
                again = session.run(new CheckAgain(paths, executable, "state.json", "this tool"));
            } catch (WrongUse e) {
                throw new AssertionError(e);
            }
            assertThat(text(again.result())).as(after).isEqualTo(text(full));
            assertThat(again.result().hasUnreadableInput()).isEqualTo(full.hasUnreadableInput());
        }

        private List<String> files() throws IOException {
            try (Stream<Path> files = Files.walk(folder)) {
                return files.filter(FileFinder::isModelFile)
                        .map(file -> folder.relativize(file).toString())
                        .filter(IncrementalCheckTest::isNamed)
                        .sorted()
                        .toList();
            }
        }
    }

    /** Others are read where those that are named refer to them. */
    private static boolean isNamed(String path) {
        return path.hashCode() % 5 != 0;
    }

    /** All that people and programs see. */
    static String text(CheckResult result) {
        CheckReport report =
                new CheckReport(
                        result.paths(), result.findings(), result.suppressed(), Optional.empty());
        return FindingsText.render(result.findings(), Style.PLAIN)
                + FindingsText.summary(report, Style.PLAIN)
                + FindingsJson.render(report);
    }

    static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            files.sorted((a, b) -> b.compareTo(a)).forEach(IncrementalCheckTest::deleteOne);
        }
    }

    private static void deleteOne(Path path) {
        try {
            Files.delete(path);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}

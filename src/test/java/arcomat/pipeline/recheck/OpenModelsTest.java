package arcomat.pipeline.recheck;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.guest.host.Guests;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckFiles;
import arcomat.pipeline.file.FileFinder;
import arcomat.pipeline.file.FileReader;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;

/** What is found while models are edited is what a check of the folder finds. */
class OpenModelsTest {
    private static final int FILES = 30;
    private static final int ROUNDS = 25;

    /** Rounds from one change of a library to the next. */
    private static final int OF_OTHERS = 5;

    @Tag("slow")
    @Property(tries = 4)
    void findsWhatAFullCheckFinds(@ForAll long seed) throws IOException {
        Path folder = Files.createTempDirectory("open");
        Path others = Files.createTempDirectory("others").toRealPath();
        try {
            Random random = new Random(seed);
            List<Path> libraries = random.nextBoolean() ? List.of(others) : List.of();
            EditedModels theirs = new EditedModels(others, random);
            EditedModels models = new EditedModels(folder, random);
            while (models.size() < FILES) {
                models.add();
            }
            boolean executable = random.nextBoolean();
            OpenModels open = OpenModels.in(folder, executable);
            Session session =
                    Session.in(folder, Progress.NONE)
                            .with(libraries.stream().map(Path::toString).toList());
            StringBuilder what = new StringBuilder("at first");
            for (int round = 0; round < ROUNDS; round++) {
                if (round % OF_OTHERS == 0) {
                    what.append(theirs.add()).append(theirs.edit()).append(theirs.add());
                    open = open.referringTo(LibraryModels.in(libraries, Guests.NONE));
                }
                open = open.with(edit(open, folder));
                if (random.nextBoolean()) {
                    open = checkSome(open, random, session, executable, what.toString());
                }
                // Not every edit is checked: some are followed by the next too soon.
                if (round == 0 || random.nextInt(3) > 0) {
                    open = open.check(() -> {});
                    assertThat(found(open))
                            .as(what.toString())
                            .isEqualTo(found(session, executable));
                    what.setLength(0);
                }
                what.append(models.edit()).append("; ");
            }
        } finally {
            IncrementalCheckTest.delete(folder);
            IncrementalCheckTest.delete(others);
        }
    }

    /** Nobody refers to tests in libraries, whatever is in them. */
    @Example
    void testsInLibrariesAreNotRead() throws IOException {
        Path library = Files.createTempDirectory("library");
        try {
            Files.writeString(library.resolve("Bell.arc"), "component Bell {}");
            Files.write(library.resolve("BellTest.mt"), new byte[] {0});
            LibraryModels read = LibraryModels.in(List.of(library), Guests.NONE);
            assertThat(read.files().keySet()).singleElement().asString().endsWith("Bell.arc");
        } finally {
            IncrementalCheckTest.delete(library);
        }
    }

    /** What is not due is known as well as after a check of all. */
    private static OpenModels checkSome(
            OpenModels open, Random random, Session session, boolean executable, String what) {
        int share = random.nextInt(4);
        OpenModels checked = open.check(path -> path.hashCode() % 4 < share, () -> {});
        Set<String> due = checked.due();
        assertThat(text(findings(checked).filter(each -> !due.contains(path(each)))))
                .as("in part, " + what)
                .isEqualTo(
                        text(
                                findings(session, executable).stream()
                                        .filter(each -> !due.contains(path(each)))));
        return checked;
    }

    private static String path(Diagnostic finding) {
        return finding.span().file().path();
    }

    /** The difference between what is open and what lies in the folder. */
    static OpenModels.Edit edit(OpenModels open, Path folder) throws IOException {
        List<SourceFile> written = new ArrayList<>();
        List<Diagnostic> unreadable = new ArrayList<>();
        Set<String> removed = new HashSet<>(open.paths());
        removed.removeIf(open::isLibrary);
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(FileFinder::isModelFile).sorted().toList()) {
                String path = folder.relativize(file).toString();
                removed.remove(path);
                FileReader.Read read = FileReader.read(file, path);
                read.finding().ifPresent(unreadable::add);
                read.file().filter(now -> isNew(now, open)).ifPresent(written::add);
            }
        }
        return new OpenModels.Edit(written, unreadable, removed);
    }

    private static boolean isNew(SourceFile now, OpenModels open) {
        return open.source(now.path()).filter(old -> old.text().equals(now.text())).isEmpty();
    }

    private static String found(OpenModels open) {
        return text(findings(open));
    }

    private static Stream<Diagnostic> findings(OpenModels open) {
        return open.checkedPaths().stream().flatMap(path -> open.findings(path).stream());
    }

    private static String found(Session session, boolean executable) {
        return text(findings(session, executable).stream());
    }

    private static List<Diagnostic> findings(Session session, boolean executable) {
        try {
            return session.run(new CheckFiles(List.of("."), executable)).findings();
        } catch (WrongUse e) {
            throw new AssertionError(e);
        }
    }

    private static String text(Stream<Diagnostic> findings) {
        StringBuilder text = new StringBuilder();
        findings.sorted(Diagnostic.ORDER)
                .forEach(
                        each ->
                                text.append(each.span())
                                        .append(' ')
                                        .append(each.code())
                                        .append(' ')
                                        .append(each.message())
                                        .append(each.related())
                                        .append('\n'));
        return text.toString();
    }
}

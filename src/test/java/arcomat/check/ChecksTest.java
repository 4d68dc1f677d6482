package arcomat.check;

import static org.assertj.core.api.Assertions.assertThat;

import static java.util.Comparator.comparing;
import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.mapping;
import static java.util.stream.Collectors.toList;

import arcomat.check.language.ToldByLanguage;
import arcomat.check.law.Check;
import arcomat.check.law.Law;
import arcomat.check.law.Profile;
import arcomat.source.Diagnostic;
import arcomat.source.Fix.TextEdit;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.tree.Unit;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.io.File;
import java.io.IOException;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Each check against its data: {@code src/test/resources/check/PortUniqueSender.arc}, or all files
 * of a folder of that name. What a file does not expect fails, and so does what it expects in vain.
 */
class ChecksTest {
    private static final Path DATA = Path.of("src/test/resources/check");
    private static final Path EXPLAIN = Path.of("src/main/resources/explain");
    private static final Path ACTUAL = Path.of("build/check-actual");

    private static final Set<String> ABOUT_ALL_FILES =
            LawBook.OWN.own().stream()
                    .filter(law -> law.check() instanceof Check.OnWorkspace)
                    .map(Law::code)
                    .collect(Collectors.toSet());

    @TestFactory
    Stream<DynamicTest> findsWhatTheDataFilesExpect() {
        return dataFiles(DATA).stream()
                .map(path -> DynamicTest.dynamicTest(name(path), () -> compare(path)));
    }

    /** Incremental checking relies on it: who looks at some files only finds all about these. */
    @TestFactory
    Stream<DynamicTest> findsSomethingAboutAFileWhereItLooksAtThatFile() {
        return dataFiles(DATA).stream()
                .map(path -> DynamicTest.dynamicTest(name(path), () -> lookAtEachFile(path)));
    }

    private static void lookAtEachFile(Path path) throws IOException {
        DataFile data = DataFile.read(path);
        Workspace workspace = Checking.workspace(data.files());
        for (Unit unit : workspace.units()) {
            Review review =
                    Checks.review(LawBook.OWN, workspace, data.profile(), unit::equals, () -> {});
            assertThat(review.findings())
                    .filteredOn(finding -> !ABOUT_ALL_FILES.contains(finding.code()))
                    .allMatch(finding -> finding.span().file() == unit.file());
        }
    }

    private static void compare(Path path) throws IOException {
        DataFile data = DataFile.read(path);
        List<Diagnostic> findings = Checking.review(data.files(), data.profile()).findings();
        List<Expectation> actual = findings.stream().map(Expectation::of).toList();
        if (!fits(data.expectations(), actual)) {
            assertThat(actual(path, data.withExpectations(actual)))
                    .as("expected findings of %s", path)
                    .isEqualTo(data.withExpectations(data.expectations()));
        }
        for (Diagnostic finding : findings) {
            checkFix(data, finding);
        }
    }

    private static boolean fits(List<Expectation> expected, List<Expectation> actual) {
        List<Expectation> open = new ArrayList<>(actual);
        for (Expectation expectation : expected) {
            Expectation met = open.stream().filter(expectation::isMetBy).findFirst().orElse(null);
            if (!open.remove(met)) {
                return false;
            }
        }
        return open.isEmpty();
    }

    /** Keeps what was found, in the form of the data file, to be compared and copied. */
    private static String actual(Path path, String text) throws IOException {
        Path copy = ACTUAL.resolve(DATA.relativize(path));
        Files.createDirectories(copy.getParent());
        Files.writeString(copy, text);
        return text;
    }

    private static void checkFix(DataFile data, Diagnostic finding) {
        if (finding.fix().isEmpty()) {
            return;
        }
        List<SourceFile> mended =
                data.files().stream().map(f -> apply(finding.fix().get().edits(), f)).toList();
        long before = count(data.files(), data.profile(), finding.code());
        assertThat(count(mended, data.profile(), finding.code()))
                .as("findings %s after: %s", finding.code(), finding.fix().get().title())
                .isLessThan(before);
        assertThat(Checking.review(mended, data.profile()).findings())
                .as("findings after: %s", finding.fix().get().title())
                .hasSizeLessThanOrEqualTo(
                        Checking.review(data.files(), data.profile()).findings().size());
    }

    private static long count(List<SourceFile> files, Profile profile, String code) {
        return Checking.review(files, profile).findings().stream()
                .filter(f -> f.code().equals(code))
                .count();
    }

    private static SourceFile apply(List<TextEdit> edits, SourceFile file) {
        StringBuilder text = new StringBuilder(file.text());
        edits.stream()
                .filter(e -> e.span().file().path().equals(file.path()))
                .sorted(comparing((TextEdit e) -> e.span().start()).reversed())
                .forEach(e -> text.replace(e.span().start(), e.span().end(), e.text()));
        return new SourceFile(file.path(), text.toString());
    }

    @TestFactory
    Stream<DynamicTest> everyCheckIsComplete() {
        return LawBook.OWN.own().stream()
                .map(law -> DynamicTest.dynamicTest(name(law), () -> checkComplete(law)));
    }

    private static void checkComplete(Law law) throws IOException {
        String code = law.code();
        assertThat(EXPLAIN.resolve(code + ".md")).content().startsWith("# " + code + " ");
        List<DataFile> data = new ArrayList<>();
        for (Path path : dataFilesOf(law)) {
            data.add(DataFile.read(path));
        }
        assertThat(data).as("data files of %s", name(law)).isNotEmpty();
        List<Expectation> expected =
                data.stream()
                        .flatMap(d -> d.expectations().stream())
                        .filter(e -> e.code().equals(code))
                        .toList();
        assertThat(expected).as("bad examples of %s", name(law)).isNotEmpty();
        assertThat(expected)
                .as("one expectation of %s with its message", name(law))
                .anyMatch(e -> !e.message().isEmpty());
        assertThat(data.stream().flatMap(d -> d.files().stream()))
                .as("good examples of %s", name(law))
                .anyMatch(f -> isGood(f, expected));
    }

    private static boolean isGood(SourceFile file, List<Expectation> expected) {
        return file.path().contains("Good")
                && expected.stream().noneMatch(e -> e.path().equals(file.path()));
    }

    @Test
    void everyCheckIsListedOnceInAlphabeticalOrder() throws IOException {
        Map<String, List<String>> listed =
                LawBook.OWN.own().stream()
                        .map(law -> law.check().getClass())
                        .distinct() // one class tells what languages have found, whichever
                        .collect(
                                groupingBy(
                                        Class::getPackageName,
                                        mapping(Class::getSimpleName, toList())));
        Map<String, List<String>> written =
                checkClasses().stream()
                        .sorted(comparing(Class::getSimpleName))
                        .collect(
                                groupingBy(
                                        Class::getPackageName,
                                        mapping(Class::getSimpleName, toList())));
        assertThat(listed).isEqualTo(written);
    }

    private static List<Class<?>> checkClasses() throws IOException {
        Path main = Path.of("src/main/java");
        try (Stream<Path> files = Files.walk(main.resolve("arcomat/check"))) {
            return files.map(file -> main.relativize(file).toString())
                    .filter(name -> name.endsWith(".java"))
                    .map(name -> name.substring(0, name.length() - ".java".length()))
                    .map(name -> name.replace(File.separatorChar, '.'))
                    .flatMap(ChecksTest::checks)
                    .toList();
        }
    }

    /** None where a class is no check. */
    private static Stream<Class<?>> checks(String name) {
        try {
            Class<?> type = Class.forName(name);
            boolean isAbstract = Modifier.isAbstract(type.getModifiers());
            return Stream.<Class<?>>of(type)
                    .filter(each -> Check.class.isAssignableFrom(each) && !isAbstract);
        } catch (ClassNotFoundException e) {
            return Stream.empty();
        }
    }

    @Test
    void everyCodeIsUsedOnce() {
        assertThat(LawBook.OWN.own().stream().map(Law::code))
                .doesNotHaveDuplicates()
                .allMatch(code -> code.matches("ARC\\d{4}"));
    }

    @Test
    void everyDataFileBelongsToACheck() {
        List<String> names = LawBook.OWN.own().stream().map(ChecksTest::name).toList();
        assertThat(dataFiles(DATA)).allMatch(path -> names.contains(owner(path)));
    }

    private static String name(Law law) {
        return law.check() instanceof ToldByLanguage told
                ? told.name()
                : law.check().getClass().getSimpleName();
    }

    private static String name(Path path) {
        return DATA.relativize(path).toString();
    }

    private static String owner(Path path) {
        return DATA.relativize(path).getName(0).toString().replace(".arc", "");
    }

    private static List<Path> dataFilesOf(Law law) {
        return dataFiles(DATA).stream().filter(p -> owner(p).equals(name(law))).toList();
    }

    private static List<Path> dataFiles(Path folder) {
        try (Stream<Path> paths = Files.walk(folder)) {
            return paths.filter(Files::isRegularFile).sorted(Comparator.naturalOrder()).toList();
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }
}

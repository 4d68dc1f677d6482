package arcomat.check;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.law.Law;
import arcomat.check.law.Profile;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The models on the pages that explain the laws: a wrong one breaks the law that the page is about
 * and no other, a right one breaks none.
 */
class ExplainPagesTest {
    private static final Path PAGES = Path.of("src/main/resources/explain");
    private static final String SEPARATOR = "//// ";
    private static final Pattern FENCE =
            Pattern.compile("```(arc|cd|mt|ioautomaton)\n(.*?)```\n", Pattern.DOTALL);
    private static final Pattern PACKAGE =
            Pattern.compile("^package ([\\w.]+);", Pattern.MULTILINE);
    private static final Pattern DEFINITION =
            Pattern.compile(
                    "^(?:<<.*>> *)?(?:component|automaton|classdiagram|testsuite) (\\w+)",
                    Pattern.MULTILINE);

    /** A wrong model would be longer than its page. */
    private static final Set<String> TOO_LONG_TO_SHOW = Set.of("ARC0608");

    @TestFactory
    Stream<DynamicTest> wrongModelsBreakTheLaw() {
        return LawBook.OWN.own().stream()
                .filter(law -> !TOO_LONG_TO_SHOW.contains(law.code()))
                .map(law -> DynamicTest.dynamicTest(law.code(), () -> wrong(law)));
    }

    @TestFactory
    Stream<DynamicTest> rightModelsBreakNone() {
        return LawBook.OWN.own().stream()
                .map(law -> DynamicTest.dynamicTest(law.code(), () -> right(law)));
    }

    private static void wrong(Law law) throws IOException {
        String code = law.code();
        assertThat(findings(law, "## Wrong"))
                .as("findings about the wrong model of %s", code)
                .anyMatch(finding -> finding.code().equals(code))
                .allMatch(finding -> finding.code().equals(code) || !finding.isError());
    }

    private static void right(Law law) throws IOException {
        assertThat(findings(law, "## Right"))
                .as("findings about the right model of %s", law.code())
                .isEmpty();
    }

    /** About the models below a heading, with those that both headings share. */
    private static List<Diagnostic> findings(Law law, String heading) throws IOException {
        String page = Files.readString(PAGES.resolve(law.code() + ".md"));
        List<SourceFile> files = new ArrayList<>(files(section(page, heading)));
        files.addAll(files(section(page, "## The component")));
        assertThat(files).as("models below %s", heading).isNotEmpty();
        return Checking.review(files, profile(law)).findings();
    }

    private static Profile profile(Law law) {
        return law.inRequirements().isPresent() ? Profile.REQUIREMENTS : Profile.EXECUTABLE;
    }

    /** From a heading to the next one of its level; empty where the page does not have it. */
    private static String section(String page, String heading) {
        int start = page.indexOf("\n" + heading + "\n");
        if (start < 0) {
            return "";
        }
        int end = page.indexOf("\n## ", start + 1);
        return page.substring(start, end < 0 ? page.length() : end);
    }

    private static List<SourceFile> files(String section) {
        List<SourceFile> files = new ArrayList<>();
        Matcher fence = FENCE.matcher(section);
        while (fence.find()) {
            String models = fence.group(2);
            if (models.startsWith(SEPARATOR)) {
                files.addAll(named(models));
            } else {
                files.add(new SourceFile(path(fence.group(1), models), models));
            }
        }
        return files;
    }

    /** Models under lines with their paths, for laws that are about files. */
    private static List<SourceFile> named(String models) {
        List<SourceFile> files = new ArrayList<>();
        for (String model : models.substring(SEPARATOR.length()).split("\n" + SEPARATOR)) {
            int end = model.indexOf('\n');
            files.add(new SourceFile(model.substring(0, end), model.substring(end + 1) + "\n"));
        }
        return files;
    }

    private static String path(String ending, String text) {
        Matcher declared = PACKAGE.matcher(text);
        String folder = declared.find() ? declared.group(1).replace('.', '/') + "/" : "";
        Matcher definition = DEFINITION.matcher(text);
        assertThat(definition.find()).as("a definition in:%n%s", text).isTrue();
        return folder + definition.group(1) + "." + ending;
    }
}

package arcomat.check;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.law.Profile;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A syntax error hides findings and makes none: whatever is broken in a file, all else that is told
 * about it and about the others was true before.
 */
class SureFindingsTest {
    private static final Path DATA = Path.of("src/test/resources/check");

    /** No braces: without them a file has no parts that could be read. */
    private static final Pattern TOKEN = Pattern.compile("[A-Za-z_]\\w*|[;,=()\\[\\]]|->");

    /** The same, with what stands in tables. */
    private static final Pattern TOKEN_OF_TABLES =
            Pattern.compile("[A-Za-z_]\\w*|=>|--|\\d+|[;,=()|*\\[\\]]");

    /** Told of one component that breaks the law: where that is broken, of another one. */
    private static final String OF_THE_INNERMOST = "ARC0131";

    private static final int BREAKS_PER_FILE = 12;

    @TestFactory
    Stream<DynamicTest> aSyntaxErrorMakesNoOtherFindings() throws IOException {
        List<Path> data;
        try (Stream<Path> paths = Files.walk(DATA)) {
            data = paths.filter(Files::isRegularFile).sorted().toList();
        }
        return data.stream()
                .map(
                        path ->
                                DynamicTest.dynamicTest(
                                        path.toString(),
                                        () -> breakEach(path, TOKEN, BREAKS_PER_FILE)));
    }

    /** Of a table, a row is left out and the others are read. */
    @ParameterizedTest
    @ValueSource(strings = {"TableCellFits", "TableColumnsExist", "TableRowWidth"})
    void nowhereInATableDoesOneMakeOthers(String name) throws IOException {
        breakEach(DATA.resolve(name + ".arc"), TOKEN_OF_TABLES, Integer.MAX_VALUE);
    }

    private static void breakEach(Path path, Pattern token, int most) throws IOException {
        List<SourceFile> files = DataFile.read(path).files();
        Set<String> before = told(files);
        for (int i = 0; i < files.size(); i++) {
            String text = files.get(i).text();
            List<MatchResult> tokens = token.matcher(text).results().toList();
            int step = Math.max(1, tokens.size() / most);
            for (int j = 0; j < tokens.size(); j += step) {
                List<SourceFile> broken = new ArrayList<>(files);
                broken.set(i, without(tokens.get(j), files.get(i)));
                if (Parser.parse(broken.get(i)).findings().isEmpty()) {
                    continue; // in a comment or in a string
                }
                assertThat(before)
                        .as("broken at '%s' in %s", tokens.get(j).group(), broken.get(i).text())
                        .containsAll(told(broken));
            }
        }
    }

    /** In its place stands what no grammar knows, so that all other places stay as they are. */
    private static SourceFile without(MatchResult token, SourceFile file) {
        String text = file.text();
        String nothing = "\u00a7".repeat(token.group().length());
        return new SourceFile(
                file.path(),
                text.substring(0, token.start()) + nothing + text.substring(token.end()));
    }

    private static Set<String> told(List<SourceFile> files) {
        Set<String> told = new TreeSet<>();
        review(files).findings().stream()
                .filter(each -> !each.code().equals(OF_THE_INNERMOST))
                .forEach(each -> told.add(each.code() + " " + each.span()));
        return told;
    }

    private static Review review(List<SourceFile> files) {
        List<Unit> units = new ArrayList<>();
        List<Recovered> recovered = new ArrayList<>();
        Set<String> broken = new HashSet<>();
        for (SourceFile file : files) {
            Parsed parsed = Parser.parse(file);
            parsed.unit().ifPresent(units::add);
            parsed.recovered().ifPresent(recovered::add);
            if (parsed.unit().isEmpty()) {
                broken.add(file.path());
            }
        }
        return Checks.review(
                        LawBook.OWN,
                        Workspace.of(units, broken, HouseLanguages.reader()),
                        Profile.EXECUTABLE,
                        unit -> true,
                        () -> {})
                .and(
                        Checks.reviewRecovered(
                                LawBook.OWN,
                                HouseLanguages.reader(),
                                recovered,
                                units,
                                broken,
                                List.of(),
                                Profile.EXECUTABLE));
    }

    /**
     * Nor does a row hide others, or swallow the one behind it where the semicolon between them is
     * missing.
     */
    @Test
    void whatIsWrongBesideARowWithASyntaxErrorIsTold() {
        SourceFile file =
                new SourceFile(
                        "Door.arc",
                        """
                        component Door {
                          port in Integer[0..3] a, out Integer[0..3] b;
                          table {
                            in a;
                            out b;
                            | 0 | => | + |;
                            | 1 | => | 3 |
                            | 2 | => | 7 |;
                            stray;
                            | 3 | => | true |;
                          }
                        }
                        """);
        assertThat(Parser.parse(file).findings())
                .extracting(each -> each.span().startPosition().line())
                .containsExactly(6, 7, 9);
        assertThat(told(List.of(file)))
                .containsExactly("ARC0322 Door.arc:8:16", "ARC0336 Door.arc:10:16");
    }

    /**
     * What columns there are is not known without the line that names them, which is no single one
     * with the next where the semicolon between them is missing.
     */
    @ParameterizedTest
    @ValueSource(strings = {"in a b;", "in a, b"})
    void whatARowHasTooMuchOfIsNotToldWhereColumnsCannotBeRead(String inputs) {
        SourceFile file =
                new SourceFile(
                        "Door.arc",
                        """
                        component Door {
                          port in Boolean a, in Boolean b, out Boolean c;
                          table {
                            %s
                            out c;
                            | true | * | => | true |;
                            | * | * | => | + |;
                          }
                        }
                        """
                                .formatted(inputs));
        assertThat(Parser.parse(file).findings())
                .extracting(each -> each.span().startPosition().line())
                .containsExactly(4, 7);
        assertThat(told(List.of(file))).isEmpty();
    }

    /** Else the laws above would hold for a tool that tells nothing. */
    @Test
    void whatIsWrongBesideASyntaxErrorIsTold() {
        SourceFile file =
                new SourceFile(
                        "Door.arc",
                        """
                        component Door {
                          port in Boolean call, out Boolean drive
                          port in Boolean drive;
                          automaton {
                            state down, up;
                            initial down;
                            down -> {call} §;
                            down -> up [call + 1] {call = true} / {drive = 3};
                            up -> gone;
                          }
                        }
                        """);
        assertThat(told(List.of(file)))
                .containsExactly(
                        "ARC0201 Door.arc:3:19",
                        "ARC0304 Door.arc:9:11",
                        "ARC0316 Door.arc:8:52",
                        "ARC0330 Door.arc:8:17");
    }
}

package arcomat.report.finding;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.report.finding.Reported.Standing;
import arcomat.report.text.Style;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.Parser;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** That a file has more errors than are told is told in every form. */
class RestOfFileTest {
    /** A semicolon is missing in each line. */
    private static List<Diagnostic> findings(String path, int errors) {
        String lines =
                IntStream.range(0, errors)
                        .mapToObj(i -> "    s [n == %d] / {o = 1}\n".formatted(i))
                        .collect(Collectors.joining());
        String text =
                "component A {\n  port in Integer n, out Integer o;\n  automaton {\n"
                        + "    state s; initial s;\n"
                        + lines
                        + "  }\n}\n";
        return Parser.parse(new SourceFile(path, text)).findings();
    }

    private static final List<Diagnostic> ALL = findings("A.arc", 50);
    private static final List<Diagnostic> SOME = findings("A.arc", 500);

    private static String sarif(List<Diagnostic> findings) {
        return Sarif.render(
                findings.stream().map(each -> Reported.of(each, Standing.NEW)).toList(),
                false,
                new Sarif.Tool("1.0.0", code -> Optional.empty()),
                new SourceRoot("/home/robot"));
    }

    @Test
    void whatIsToldInFullIsNoMore() {
        assertThat(ALL).hasSize(50).allMatch(Diagnostic::isError);
        assertThat(FindingsText.summary(ALL, 1, Style.PLAIN)).isEqualTo("50 errors in 1 file");
        assertThat(FindingsJson.render(ALL, 1)).doesNotContain("incomplete");
        assertThat(sarif(ALL)).doesNotContain("invocations");
    }

    @Test
    void theFirstErrorThatIsNotToldIsThePlaceOfTheWarning() {
        assertThat(SOME).hasSize(51);
        Diagnostic last = SOME.get(50);
        assertThat(last.code()).isEqualTo("ARC0008");
        assertThat(last.isError()).isFalse();
        assertThat(last.span().startPosition().line()).isEqualTo(4 + 51);
    }

    @Test
    void theSumSaysWhatWasNotLookedAt() {
        assertThat(FindingsText.summary(SOME, 1, Style.PLAIN))
                .isEqualTo("50 errors, 1 warning in 1 file; the rest of A.arc was not looked at");
        List<Diagnostic> both = List.of(SOME.get(50), findings("B.arc", 51).get(50));
        assertThat(FindingsText.summary(both, 3, Style.PLAIN))
                .isEqualTo("2 warnings in 3 files; the rest of 2 files was not looked at");
    }

    @Test
    void programsAreToldToo() {
        assertThat(FindingsJson.render(SOME, 1))
                .contains("\"errors\" : 50", "\"incomplete\" : [\n    \"A.arc\"\n  ]");
        assertThat(sarif(SOME))
                .contains(
                        "\"toolExecutionNotifications\"",
                        "the syntax of the rest of A.arc was not looked at");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "component A { port in in String s; /* open",
                "component A { port in in String s; port in String t = \"open\n; }",
                "component A { port in in String s; port in String \u202et; }",
                "component A { port in in String s; port in String t\u0300\u0301x; }"
            })
    void whatIsNotParsedIsNamed(String text) {
        List<Diagnostic> findings = Parser.parse(new SourceFile("A.arc", text)).findings();
        assertThat(findings).hasSize(2);
        assertThat(findings.get(0).isError()).isTrue();
        assertThat(findings.get(1).code()).isEqualTo("ARC0008");
        assertThat(FindingsText.summary(findings, 1, Style.PLAIN))
                .isEqualTo("1 error, 1 warning in 1 file; the rest of A.arc was not looked at");
    }

    @Test
    void ofAnEmptyFileNothingIsLeft() {
        List<Diagnostic> findings = Parser.parse(new SourceFile("A.arc", "// nothing")).findings();
        assertThat(findings).hasSize(1);
    }
}

package arcomat.syntax;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.Diagnostic;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Every finding about a text, with its exact range and message, beside the text. */
class SyntaxErrorTest {
    @TestFactory
    List<DynamicTest> textGivesFindings() {
        List<DynamicTest> tests = new ArrayList<>();
        for (Path path : Samples.in("errors", ".findings")) {
            tests.add(DynamicTest.dynamicTest(path.getFileName().toString(), () -> check(path)));
        }
        return tests;
    }

    private static void check(Path path) {
        Parsed parsed = Parser.parse(Samples.file(path));
        assertThat(parsed.unit()).isEmpty();
        String seen = text(parsed.findings());
        Path golden = path.resolveSibling(path.getFileName() + ".findings");
        if (Samples.REFRESH) {
            Samples.write(golden, seen);
        }
        assertThat(seen).isEqualTo(Samples.read(golden));
        assertThat(text(Formatter.format(Samples.file(path)).findings())).isEqualTo(seen);
    }

    private static String text(List<Diagnostic> findings) {
        StringBuilder text = new StringBuilder();
        for (Diagnostic finding : findings) {
            text.append(line(finding));
        }
        return text.toString();
    }

    private static String line(Diagnostic finding) {
        StringBuilder text = new StringBuilder();
        text.append(finding.span().startPosition()).append('-');
        text.append(finding.span().endPosition()).append(' ').append(finding.code()).append(' ');
        text.append(finding.message()).append('\n');
        finding.related()
                .forEach(
                        r ->
                                text.append("    ")
                                        .append(r.span().startPosition())
                                        .append(' ')
                                        .append(r.note())
                                        .append('\n'));
        return text.toString();
    }

    @Test
    void missingSemicolonCanBeInserted() {
        Diagnostic finding =
                Parser.parse(Texts.component("port in Integer a\n  connect a -> b;"))
                        .findings()
                        .get(0);
        assertThat(finding.fix().orElseThrow().edits().get(0).text()).isEqualTo(";");
        assertThat(finding.fix().orElseThrow().edits().get(0).span().start())
                .isEqualTo(finding.span().end());
    }
}

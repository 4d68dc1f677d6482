package arcomat.syntax;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.SourceFile;

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

    /** A repair may uncover what was not read before; what it is about is well then. */
    @TestFactory
    List<DynamicTest> repairsRepair() {
        List<DynamicTest> tests = new ArrayList<>();
        for (Path path : Samples.in("errors", ".findings")) {
            SourceFile file = Samples.file(path);
            for (Diagnostic finding : Parser.parse(file).findings()) {
                finding.fix()
                        .ifPresent(
                                fix ->
                                        tests.add(
                                                DynamicTest.dynamicTest(
                                                        path.getFileName() + ": " + fix.title(),
                                                        () -> repair(file, fix))));
            }
        }
        return tests;
    }

    private static void repair(SourceFile file, Fix fix) {
        Fix.TextEdit edit = fix.edits().get(0);
        String text = file.text();
        String mended =
                text.substring(0, edit.span().start())
                        + edit.text()
                        + text.substring(edit.span().end());
        List<Diagnostic> after = Parser.parse(new SourceFile(file.path(), mended)).findings();
        assertThat(after).hasSizeLessThanOrEqualTo(Parser.parse(file).findings().size());
        int end = edit.span().start() + edit.text().length();
        assertThat(after)
                .noneMatch(
                        each ->
                                each.span().start() >= edit.span().start()
                                        && each.span().start()
                                                < Math.max(end, edit.span().start() + 1));
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

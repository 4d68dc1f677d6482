package arcomat.syntax;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.SourceFile;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Canonical text: as expected beside the sample, a fixed point, and the same tree. */
class FormatterTest {
    @TestFactory
    List<DynamicTest> textGivesCanonicalText() {
        List<DynamicTest> tests = new ArrayList<>();
        for (Path path : Samples.in("format", ".formatted")) {
            tests.add(DynamicTest.dynamicTest(path.getFileName().toString(), () -> golden(path)));
        }
        for (Path path : Samples.in("shape", ".tree")) {
            tests.add(
                    DynamicTest.dynamicTest(
                            path.getFileName().toString(), () -> check(Samples.file(path))));
        }
        return tests;
    }

    private static void golden(Path path) {
        String seen = check(Samples.file(path));
        Path golden = path.resolveSibling(path.getFileName() + ".formatted");
        if (Samples.REFRESH) {
            Samples.write(golden, seen);
        }
        assertThat(seen).isEqualTo(Samples.read(golden));
    }

    @Test
    void lineBreaksAreLikeTheFirstOne() {
        String text = "component C{ // one\n/* a\nb */ port in Integer i;\n}\n";
        String unix = check(new SourceFile("C.arc", text));
        assertThat(unix).isNotEqualTo(text).doesNotContain("\r");
        assertThat(check(new SourceFile("C.arc", text.replace("\n", "\r\n"))))
                .isEqualTo(unix.replace("\n", "\r\n"));
        String mixed = "component C{\n}\r\n";
        assertThat(check(new SourceFile("C.arc", mixed))).isEqualTo("component C { }\n");
    }

    /** Gives the canonical text. */
    static String check(SourceFile file) {
        String text = Formatter.format(file).text().orElseThrow();
        SourceFile canonical = new SourceFile(file.path(), text);
        assertThat(Formatter.format(canonical).text()).contains(text);
        assertThat(TreeText.of(Parser.parse(canonical).unit().orElseThrow()))
                .isEqualTo(TreeText.of(Parser.parse(file).unit().orElseThrow()));
        return text;
    }
}

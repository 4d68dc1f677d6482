package arcomat.report.finding;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.report.finding.Reported.Standing;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import org.junit.jupiter.api.Test;

import java.util.List;

class GitHubCommandsTest {
    private static final SourceRoot ROOT = new SourceRoot("/home/robot");

    private static String command(String path, String text, int start, int end, String message) {
        Diagnostic finding =
                Diagnostic.error("ARC0104", new SourceFile(path, text).span(start, end), message);
        return GitHubCommands.render(List.of(Reported.of(finding, Standing.NEW)), ROOT);
    }

    @Test
    void aPlaceOnOneLineHasColumns() {
        assertThat(command("a/B.arc", "one\ntwo\n", 4, 7, "no"))
                .isEqualTo("::error file=a/B.arc,line=2,col=1,endColumn=4,title=ARC0104::no\n");
    }

    @Test
    void aPlaceOverSeveralLinesHasLinesOnly() {
        assertThat(command("a/B.arc", "one\ntwo\n", 1, 7, "no"))
                .isEqualTo("::error file=a/B.arc,line=1,endLine=2,title=ARC0104::no\n");
    }

    @Test
    void aFileWithoutTextHasNoLines() {
        assertThat(command("/home/robot/a", "", 0, 0, "no"))
                .isEqualTo("::error file=a,title=ARC0104::no\n");
    }

    @Test
    void whatWouldEndAPropertyOrTheMessageIsEscaped() {
        assertThat(command("a,b:50%.arc", "", 0, 0, "100% :: of\nthis, too\r"))
                .isEqualTo(
                        "::error file=a%2Cb%3A50%25.arc,title=ARC0104::"
                                + "100%25 :: of%0Athis, too\n");
    }

    @Property
    void aCommandIsOneLineWhateverItSays(@ForAll String path, @ForAll String message) {
        assertThat(command(path, "", 0, 0, message).lines()).hasSize(1);
    }
}

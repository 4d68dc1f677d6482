package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.DataFile;
import arcomat.models.ReadModels;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Who does as the finding says is rid of it. */
class ForgottenSilenceTest {
    private static final Path DATA =
            Path.of("verify/src/test/resources/analyze/ForgottenSilence.arc");
    private static final Pattern INSTEAD = Pattern.compile("write '(.*)' if silence counts");
    private static final Pattern HANDLED = Pattern.compile("else handle '(.*)'");

    @Test
    void whatToWriteInsteadHolds() throws IOException {
        for (SourceFile file : DataFile.read(DATA).files()) {
            for (Diagnostic finding : found(file)) {
                SourceFile changed = withInstead(finding, file);
                assertThat(found(changed)).as(changed.text()).hasSize(found(file).size() - 1);
            }
        }
    }

    @Test
    void aTransitionOfItsOwnIsAnAnswer() throws IOException {
        for (SourceFile file : DataFile.read(DATA).files()) {
            for (Diagnostic finding : found(file)) {
                Matcher asked = HANDLED.matcher(finding.message());
                assertThat(asked.find()).isTrue();
                String line = finding.span().file().line(finding.span().startPosition().line());
                String source = line.strip().split("[^a-z]")[0];
                String text =
                        file.text()
                                .replace(
                                        line,
                                        "    %s [%s];%n".formatted(source, asked.group(1)) + line);
                SourceFile changed = new SourceFile(file.path(), text);
                assertThat(found(changed)).as(text).hasSize(found(file).size() - 1);
            }
        }
    }

    private static SourceFile withInstead(Diagnostic finding, SourceFile file) {
        Matcher instead = INSTEAD.matcher(finding.message());
        assertThat(instead.find()).isTrue();
        StringBuilder text = new StringBuilder(file.text());
        text.replace(finding.span().start(), finding.span().end(), instead.group(1));
        return new SourceFile(file.path(), text.toString());
    }

    private static List<Diagnostic> found(SourceFile file) {
        return Models.examine(ReadModels.model(List.of(file))).stream()
                .flatMap(each -> each.findings().stream())
                .map(Finding::diagnostic)
                .filter(each -> each.code().equals(ForgottenSilence.CODE))
                .toList();
    }
}

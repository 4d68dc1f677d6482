package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.models.ReadModels;
import arcomat.source.SourceFile;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** On the pages that explain, the wrong model has the finding and no other, the right one none. */
class ExplainedFindingsTest {
    private static final Pattern MODELS =
            Pattern.compile(
                    "## Wrong\n\n```arc\n(.*?)```\n\n## Right\n\n```arc\n(.*?)```\n",
                    Pattern.DOTALL);

    @ParameterizedTest
    @ValueSource(
            strings = {
                Overlap.CODE,
                Completeness.CODE,
                UnreachableState.CODE,
                DeadTransition.CODE,
                Trap.CODE,
                VacuousOnSilence.CODE,
                RangeOverflow.CODE,
                DivisionByZero.CODE,
                IntegerOverflow.CODE
            })
    void theModelsShowIt(String code) throws IOException {
        String page = Files.readString(Path.of("src/main/resources/explain", code + ".md"));
        Matcher models = MODELS.matcher(page);
        assertThat(models.find()).isTrue();
        assertThat(codes(models.group(1))).isNotEmpty().containsOnly(code);
        assertThat(codes(models.group(2))).isEmpty();
    }

    private static List<String> codes(String text) {
        String name = text.replaceAll("(?s)component (\\w+).*", "$1");
        List<SourceFile> files = List.of(new SourceFile(name + ".arc", text));
        return Models.examine(ReadModels.model(files)).stream()
                .flatMap(each -> each.findings().stream())
                .map(Finding::code)
                .toList();
    }
}

package arcomat.analysis.mona;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Sections;
import arcomat.analysis.refinement.MonaRefinement;
import arcomat.analysis.refinement.VerdictsTest;
import arcomat.analysis.search.Budget;
import arcomat.generate.MonaText;
import arcomat.generate.Target;
import arcomat.model.Model;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Texts for MONA as they are, kept to be read and compared; {@code -PrefreshGolden} writes them
 * anew. The questions are those of {@link VerdictsTest}: the figures of the paper; an automaton
 * with errors, with steps that look alike, and with names that MONA does not know; two
 * requirements.
 */
class MonaTextTest {
    private static final Path FOLDER = Path.of("verify/src/test/resources/golden/mona");

    @ParameterizedTest
    @CsvSource({
        "coffee.txt, coffee.fig5.AvoidCrash, coffee.fig3.AvoidCrash, figure5-figure3.mona",
        "shapes.txt, n.Tor, n.Tor, errors-picks-names.mona",
        "shapes.txt, n.Both, n.Pair, requirements.mona",
    })
    void isAsItWas(String models, String left, String right, String file) throws IOException {
        Model model = Sections.read(VerdictsTest.FOLDER.resolve(models)).model();
        String text =
                MonaText.render(
                        MonaRefinement.of(
                                        promise(model, left),
                                        promise(model, right),
                                        Budget.ofMemory())
                                .formula());
        assertThat(MonaText.isQuestion(text)).isTrue();
        Path golden = FOLDER.resolve(file);
        if (Boolean.getBoolean("golden.refresh")) {
            Files.createDirectories(FOLDER);
            Files.writeString(golden, text);
        }
        assertThat(text).isEqualTo(Files.readString(golden));
    }

    private static Promise promise(Model model, String name) {
        return Promise.of(model.component(name).orElseThrow(), List.of());
    }

    @Test
    void itsTemplateIsNoTargetForCode() {
        assertThat(Target.shipped("mona")).isEmpty();
    }

    /** What somebody else has written is not overwritten. */
    @Test
    void aQuestionOfSomebodyElseIsNone() {
        assertThat(MonaText.isQuestion("# By hand.\nm2l-str;\n")).isFalse();
    }
}

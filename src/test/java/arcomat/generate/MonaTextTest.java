package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Budget;
import arcomat.analysis.MonaRefinement;
import arcomat.analysis.Promise;
import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * The text for MONA as it is, kept to be read and compared; {@code -PrefreshGolden} writes it anew.
 */
class MonaTextTest {
    private static final Path GOLDEN =
            Path.of("src/test/resources/golden/mona/figure5-figure3.mona");

    @Test
    void theFiguresOfThePaperAreAskedAboutAsTheyWere() throws IOException {
        Model model = Lowering.lower(Scenario.models("models/coffee"));
        String text =
                MonaText.render(
                        MonaRefinement.of(
                                        promise(model, "coffee.fig5.AvoidCrash"),
                                        promise(model, "coffee.fig3.AvoidCrash"),
                                        Budget.ofMemory())
                                .formula());
        if (Boolean.getBoolean("golden.refresh")) {
            Files.createDirectories(GOLDEN.getParent());
            Files.writeString(GOLDEN, text);
        }
        assertThat(text).isEqualTo(Files.readString(GOLDEN));
    }

    private static Promise promise(Model model, String name) {
        return Promise.of(model.component(name).orElseThrow(), List.of());
    }

    @Test
    void itsTemplateIsNoTargetForCode() {
        assertThat(Target.shipped("mona")).isEmpty();
    }
}

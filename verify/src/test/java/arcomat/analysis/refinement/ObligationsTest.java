package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.Obligations.Obligation;
import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.pipeline.analysis.InstanceArguments;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Test;

import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What has to be shown of some models, a line each. */
class ObligationsTest {
    private static final Path DATA = Path.of("verify/src/test/resources/analysis/obligations.txt");

    @Test
    void whoKeepsWhat() {
        Scenario scenario = Scenario.read(DATA);
        Model model = Lowering.lower(scenario.workspace());
        Obligations.All all =
                Obligations.of(model, model.components(), InstanceArguments.in(model)::of);
        String text =
                Stream.concat(
                                all.obligations().stream().map(ObligationsTest::text),
                                all.open().stream().map(name -> name + " takes arguments"))
                        .collect(Collectors.joining("\n", "", "\n"));
        assertThat(text).isEqualTo(scenario.expected());
    }

    /** With the place that it is about. */
    private static String text(Obligation obligation) {
        return obligation.left().title()
                + " keeps "
                + obligation.right().title()
                + " at "
                + obligation.place();
    }
}

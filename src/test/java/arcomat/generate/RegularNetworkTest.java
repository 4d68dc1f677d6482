package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Test;

import java.nio.file.Path;
import java.util.Map;

/** Networks of many parts of one component get loops; the agreement test runs the same models. */
class RegularNetworkTest {
    private static final Model NETWORKS =
            Lowering.lower(
                    Scenario.read(Path.of("src/test/resources/agreement/networks.txt"))
                            .workspace());

    private static String code(String component, Choosing choosing) {
        Request request =
                Request.library(NETWORKS.component("p." + component).orElseThrow(), choosing);
        return Generator.generate(request, Target.shipped("jvm").orElseThrow()).files().stream()
                .filter(file -> file.path().endsWith("/" + component + ".java"))
                .findFirst()
                .orElseThrow()
                .text();
    }

    private static String step(String component, Choosing choosing) {
        String code = code(component, choosing);
        return code.substring(code.indexOf("public void step()"));
    }

    @Test
    void orderOfDeclarationMakesNoDifference() {
        assertThat(step("GridInNoOrder", Choosing.FIRST))
                .hasSameSizeAs(step("Grid", Choosing.FIRST));
    }

    @Test
    void chainsAreServedLayerByLayer() {
        assertThat(step("Chains", Choosing.FIRST))
                .contains("i < 36;", "Cell sender = cells[i + 9];", "receiver.a = sender.b;");
    }

    @Test
    void partsWithOtherArgumentsShareTheLoop() {
        assertThat(code("Shuffled", Choosing.FIRST))
                .contains("cells[0] = new Cell(13);", "cells[i] = new Cell(1);")
                .contains("Cell sender = cells[i + 1];", "receiver.a = sender.b;");
    }

    @Test
    void everyOtherElementCanBeASource() {
        assertThat(step("Tree", Choosing.FIRST))
                .contains("Join sender = joins[2 * i + 1];", "Join sender2 = joins[2 * i + 2];");
    }

    @Test
    void partsThatDrawKeepTheirOrder() {
        assertThat(step("DiceInOrder", Choosing.RANDOM))
                .contains("Undecided sender = undecideds[i - 1];")
                .contains("for (int i = 0; i < 10; i++) {\n            undecideds[i].step();");
        assertThat(step("DiceInOrder", Choosing.FIRST))
                .contains("Undecided sender = undecideds[i + 1];");
    }

    @Test
    void partsThatMayFailKeepTheirOrder() {
        assertThat(step("OneIsTight", Choosing.FIRST)).doesNotContain("Receivers before senders");
    }

    /** Who drives generated code looks into its parts, wherever they are held. */
    @Test
    void eachPartHasItsPlace() {
        Map<String, String> parts = parts("Shuffled");
        assertThat(parts)
                .hasSize(14)
                .containsEntry("c12", "cells[1]")
                .containsEntry("c13", "cells[0]");
    }

    private static Map<String, String> parts(String component) {
        Component whole = NETWORKS.component("p." + component).orElseThrow();
        Target target = Target.shipped("jvm").orElseThrow();
        return Generator.generate(Request.library(whole, Choosing.FIRST), target)
                .layout()
                .components()
                .get(whole.qualifiedName())
                .parts();
    }
}

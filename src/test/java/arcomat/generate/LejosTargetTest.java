package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;

/** What generated code for the brick has in common with code for the JVM, and what not. */
class LejosTargetTest {
    private static final Target JVM = Target.shipped("jvm").orElseThrow();
    private static final Target LEJOS = Target.shipped("lejos").orElseThrow();

    private static Map<String, String> files(Target target, Request request) {
        Generation generation = Generator.generate(request, target);
        assertThat(generation.findings()).isEmpty();
        Map<String, String> files = new TreeMap<>();
        generation.files().forEach(file -> files.put(file.path(), file.text()));
        return files;
    }

    /** All that is no program is the same; platform components come from somewhere else. */
    private static void assertSameLogic(Model model) {
        Request request = Request.all(model, Choosing.FIRST);
        Map<String, String> jvm = files(JVM, request);
        Map<String, String> implementations = new HashMap<>();
        jvm.keySet().forEach(path -> implementations.put(path, "by hand"));
        Map<String, String> lejos = files(LEJOS, request.with(implementations));
        assertThat(lejos.keySet()).isEqualTo(jvm.keySet());
        lejos.forEach(
                (path, text) -> {
                    if (!text.equals("by hand") && !path.endsWith("Program.java")) {
                        assertThat(text).as(path).isEqualTo(jvm.get(path));
                    }
                });
    }

    @Test
    void theLogicOfTheRobotsIsThatOfTheJvm() {
        assertSameLogic(Lowering.lower(Scenario.models("models/coffee")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"expressions", "names", "events"})
    void soIsAllOtherLogic(String scenario) {
        Path file = Path.of("src/test/resources/agreement", scenario + ".txt");
        assertSameLogic(Lowering.lower(Scenario.read(file).workspace()));
    }

    @Test
    void aTargetOfOnesOwnMayStandOnAShippedOne() {
        Target own =
                new Target(
                                "my/brick",
                                Map.of(
                                        Target.DESCRIPTION,
                                        "base = jvm\ntemplate.program.ftl = program | {name}.txt\n",
                                        "program.ftl",
                                        "run ${head.name} every ${cycle} ms\n"))
                        .on(Target.shipped("jvm"));
        assertThat(own.baseName()).contains("jvm");
        Model coffee = Lowering.lower(Scenario.models("models/coffee"));
        Map<String, String> files = files(own, Request.all(coffee, Choosing.FIRST));
        assertThat(files).containsEntry("FetcherProgram.txt", "run Fetcher every 100 ms\n");
        assertThat(files).containsKey("coffee/fetcher/logic/Fetcher.java");
        assertThat(files).doesNotContainKey("coffee/fetcher/logic/FetcherProgram.java");
    }
}

package arcomat.pipeline.compile;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;

/** Java accepts the main program of any component, also of one that the platform brings. */
class ProgramTest {
    @TestFactory
    Stream<DynamicTest> compiles() {
        return Scenario.in("agreement").stream()
                .flatMap(ProgramTest::components)
                .filter(component -> component.parameters().isEmpty())
                .map(
                        component ->
                                DynamicTest.dynamicTest(
                                        component.qualifiedName(), () -> check(component)));
    }

    private static Stream<Component> components(Path file) {
        Model model = Lowering.lower(Scenario.read(file).workspace());
        return model.components().stream();
    }

    private static void check(Component component) {
        Target target = Target.shipped("jvm").orElseThrow();
        for (Choosing choosing : Choosing.values()) {
            Generation generation =
                    Generator.generate(Request.program(component, choosing), target);
            assertThat(generation.findings()).isEmpty();
            Map<String, String> sources = new HashMap<>();
            for (GeneratedFile file : generation.files()) {
                sources.put(file.path(), file.text());
            }
            Compilation compilation = MemoryCompiler.compile(sources, Map.of(), ClassFiles.RUNTIME);
            assertThat(compilation.problems()).isEmpty();
        }
    }
}

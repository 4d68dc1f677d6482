package arcomat.semantics;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Variable;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Scope;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** What expressions are worth, line by line in {@code src/test/resources/semantics/values.txt}. */
class ValuesTest {
    private static final Path VALUES = Path.of("src/test/resources/semantics/values.txt");

    @TestFactory
    Stream<DynamicTest> expressionsHaveTheValuesBesideThem() throws IOException {
        return Files.readAllLines(VALUES).stream()
                .filter(line -> !line.startsWith("#"))
                .map(line -> DynamicTest.dynamicTest(line, () -> check(line)));
    }

    private static void check(String line) {
        String[] typed = line.split(": ", 2);
        String[] valued = typed[1].split(" -> ");
        assertThat(value(typed[0], valued[0])).isEqualTo(valued[1]);
    }

    private static String value(String type, String expression) {
        Component component = component("%s v = %s;".formatted(type, expression));
        Component bare = ComponentBuilder.component("C").build();
        Variable constant = component.constants().get(0);
        try {
            return new Scope(bare, List.of()).first(component, constant).toString();
        } catch (Fault fault) {
            return fault.getMessage();
        }
    }

    private static Component component(String constant) {
        Scenario scenario =
                Scenario.of("==== a/C.arc\npackage a;\ncomponent C {\n" + constant + "\n}\n");
        return Lowering.lower(scenario.workspace()).component("a.C").orElseThrow();
    }
}

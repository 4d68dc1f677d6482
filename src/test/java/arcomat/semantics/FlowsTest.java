package arcomat.semantics;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.expression.DataSorts;
import arcomat.semantics.expression.DataSorts.Sort;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Which data are of one sort, and what is done with them: as data, automaton by automaton. */
class FlowsTest {
    private static final Path FLOWS = Path.of("src/test/resources/semantics/flows.txt");

    @TestFactory
    Stream<DynamicTest> tellsWhatDataAreGoodFor() {
        Scenario scenario = Scenario.read(FLOWS);
        Model model = Lowering.lower(scenario.workspace());
        return scenario.expected()
                .lines()
                .map(line -> line.split(": "))
                .map(line -> DynamicTest.dynamicTest(line[0], () -> check(model, line)));
    }

    private static void check(Model model, String[] line) {
        Component component = model.component("a." + line[0]).orElseThrow();
        StepRelation relation = ComponentSemantics.of(component, List.of()).relations().get(0);
        assertThat(text(relation)).isEqualTo(line[1]);
    }

    private static String text(StepRelation relation) {
        DataSorts sorts = new DataSorts();
        Map<String, Integer> places = new LinkedHashMap<>();
        for (Port port : relation.component().ports()) {
            places.put(port.name(), sorts.place(port.type()));
        }
        int[] variables = relation.tellFlow(sorts, places);
        List<Variable> declared = relation.automaton().variables();
        for (int i = 0; i < variables.length; i++) {
            places.put(declared.get(i).name(), variables[i]);
        }
        Map<Sort, List<String>> named = new LinkedHashMap<>();
        places.forEach(
                (name, place) ->
                        named.computeIfAbsent(sorts.sort(place), s -> new ArrayList<>()).add(name));
        return named.entrySet().stream()
                .map(each -> String.join(" ", each.getValue()) + text(each.getKey()))
                .collect(Collectors.joining("; "));
    }

    private static String text(Sort sort) {
        String constants =
                sort.constants().stream().map(Value::toString).collect(Collectors.joining(", "));
        return text(sort.type())
                + (sort.free() ? "" : " calculated")
                + (sort.ordered() ? " ordered" : "")
                + (constants.isEmpty() ? "" : " " + constants);
    }

    private static String text(Type type) {
        if (!(type instanceof Type.IntegerType integer)) {
            return "";
        }
        return integer.ranged()
                ? " of " + integer.low() + ".." + integer.high()
                : " of " + integer.width().name().toLowerCase(Locale.ROOT);
    }
}

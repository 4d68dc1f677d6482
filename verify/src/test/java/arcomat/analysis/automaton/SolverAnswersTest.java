package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.RunProperties;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.Reachability;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.search.Budget;
import arcomat.lower.Lowering;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * What the solvers answer to some questions about automata: the number of letters of a shortest
 * run, {@code never}, or why it is open. Where trying comes to an end, it says the same, and so
 * does each of them alone.
 */
class SolverAnswersTest {
    private static final Path DATA = Path.of("verify/src/test/resources/analysis/solver.txt");

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> answers() {
        Scenario scenario = Scenario.read(DATA);
        Model model = Lowering.lower(scenario.workspace());
        return Stream.of(scenario.expected().split("(?m)^(?=\\S)"))
                .map(part -> part.lines().toList())
                .map(
                        part ->
                                DynamicTest.dynamicTest(
                                        part.get(0),
                                        () ->
                                                check(
                                                        model,
                                                        part.get(0),
                                                        part.subList(1, part.size()))));
    }

    private static void check(Model model, String name, List<String> expected) {
        Component component = model.component("n." + name).orElseThrow();
        Automaton automaton = ((Component.Atomic) component.body()).automata().get(0);
        Subject subject = Subject.of(component, automaton, Models.arguments(component));
        Map<String, RunProperty> asked = new LinkedHashMap<>();
        for (RunProperty question : new RunProperties(subject).all()) {
            String words = new RunProperties(subject).words(question);
            if (expected.stream().anyMatch(line -> line.endsWith(": " + words))) {
                asked.put(words, question);
            }
        }
        Map<RunProperty, Reachability> outcomes =
                Models.answers(subject, asked.values(), Models.SOLVERS);
        List<String> lines = new ArrayList<>();
        asked.forEach(
                (words, question) -> lines.add(answer(outcomes.get(question)) + ": " + words));
        assertThat(lines).containsExactlyElementsOf(expected.stream().map(String::strip).toList());
        compareWithTrying(subject, outcomes);
        for (Logic.Kind<?> solver : Models.SOLVERS) {
            compare(Models.answers(subject, asked.values(), List.of(solver)), outcomes);
        }
    }

    /** What one solver says alone is what they say one after the other. */
    private static void compare(
            Map<RunProperty, Reachability> alone, Map<RunProperty, Reachability> together) {
        alone.forEach(
                (question, outcome) -> {
                    if (!(outcome instanceof Reachability.Unknown)) {
                        assertThat(answer(outcome)).isEqualTo(answer(together.get(question)));
                    }
                });
    }

    private static String answer(Reachability outcome) {
        if (outcome instanceof Reachability.Reachable found) {
            return String.valueOf(found.run().letters().size());
        }
        return outcome instanceof Reachability.Unknown open ? open.reason() : "never";
    }

    private static void compareWithTrying(
            Subject subject, Map<RunProperty, Reachability> outcomes) {
        Budget few = Budget.ofMemory().atMost(500);
        Exploration explored = new Exploration(subject, situation -> {}, few);
        explored.run();
        outcomes.forEach(
                (question, outcome) -> {
                    if (outcome instanceof Reachability.Unreachable) {
                        assertThat(explored.shown()).doesNotContain(question);
                    } else if (outcome instanceof Reachability.Reachable && explored.isComplete()) {
                        assertThat(explored.shown()).contains(question);
                    }
                });
    }
}

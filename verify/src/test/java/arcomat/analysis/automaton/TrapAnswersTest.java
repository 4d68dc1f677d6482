package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Solving;
import arcomat.analysis.automaton.exploration.Traps;
import arcomat.analysis.automaton.trap.TrapSearch;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.system.ConfigurationText;
import arcomat.lower.Lowering;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Whether solvers find traps, or that there is none. */
class TrapAnswersTest {
    private static final Path DATA = Path.of("verify/src/test/resources/analysis/traps.txt");

    /** What has no end is left to the solvers at once. */
    private static final Budget BUDGET = Budget.ofMemory().atMost(50);

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> answers() {
        Scenario scenario = Scenario.read(DATA);
        List<String> expected = List.of(scenario.expected().split("\n(?! )"));
        List<Component> components = Lowering.lower(scenario.workspace()).components();
        assertThat(expected).hasSameSizeAs(components);
        return IntStream.range(0, expected.size())
                .mapToObj(
                        i ->
                                DynamicTest.dynamicTest(
                                        components.get(i).name(),
                                        () -> compare(components.get(i), expected.get(i))));
    }

    private static void compare(Component component, String expected) {
        Automaton automaton = ((Component.Atomic) component.body()).automata().get(0);
        List<String> lines = new ArrayList<>(List.of(component.name()));
        lines.addAll(answer(Subject.of(component, automaton, List.of())));
        assertThat(String.join("\n", lines)).isEqualTo(expected.strip());
    }

    static List<String> answer(Subject subject) {
        Exploration explored = new Exploration(subject, situation -> {}, BUDGET);
        explored.run();
        Knowledge known = new Solving(subject, situation -> {}, BUDGET).after(explored);
        Traps traps = TrapSearch.of(known, BUDGET);
        List<String> lines = new ArrayList<>();
        traps.entered().forEach(each -> lines.add(words(each, subject)));
        if (!traps.obstacle().isEmpty()) {
            lines.add("  open: " + traps.obstacle());
        }
        return lines.isEmpty() ? List.of("  none") : lines;
    }

    private static String words(Traps.Entry entry, Subject subject) {
        List<String> states = entry.states().stream().map(subject::state).toList();
        return "  after %d: %s, in %s%s"
                .formatted(
                        entry.visit().length(),
                        ConfigurationText.of(subject.automaton(), entry.visit().configuration()),
                        states,
                        entry.isWhole() ? "" : " at most");
    }
}

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

import org.junit.jupiter.api.Test;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Whether solvers find traps, or that there is none. */
class TrapAnswersTest {
    private static final Path DATA = Path.of("src/test/resources/analysis/traps.txt");

    /** What has no end is left to the solvers at once. */
    private static final Budget BUDGET = Budget.ofMemory().atMost(50);

    @Test
    void answers() {
        Scenario scenario = Scenario.read(DATA);
        List<String> lines = new ArrayList<>();
        for (Component each : Lowering.lower(scenario.workspace()).components()) {
            lines.add(each.name());
            Automaton automaton = ((Component.Atomic) each.body()).automata().get(0);
            lines.addAll(answer(Subject.of(each, automaton, List.of())));
        }
        assertThat(String.join("\n", lines) + "\n").isEqualTo(scenario.expected());
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

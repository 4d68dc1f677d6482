package arcomat.analysis.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.coverage.Mutants.Mutant;
import arcomat.diagram.AutomatonGraph;
import arcomat.diagram.Graph;
import arcomat.lower.Lowering;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Test;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The small mistakes that tests are to tell: a line each, with what the transition reads then, as
 * pictures have it.
 */
class MutantsTest {
    private static final Path DATA =
            Path.of("verify/src/test/resources/analysis/tests/mistakes.txt");

    @Test
    void eachIsTheAutomatonWithOneMistake() {
        Scenario scenario = Scenario.read(DATA);
        String text =
                Lowering.lower(scenario.workspace()).components().stream()
                        .flatMap(MutantsTest::text)
                        .collect(Collectors.joining("\n", "", "\n"));
        assertThat(text).isEqualTo(scenario.expected());
    }

    private static Stream<String> text(Component component) {
        Automaton automaton = component.automata().get(0);
        List<Mutant> mutants = new Mutants(component, automaton).all();
        return Stream.concat(
                Stream.of(component.name()),
                mutants.stream().map(mutant -> text(component, automaton, mutant)));
    }

    private static String text(Component component, Automaton right, Mutant mutant) {
        Goal goal = mutant.mistake().transition();
        assertThat(goal.automaton()).isSameAs(right);
        List<String> wrong = stories(component, mutant.automaton());
        List<String> kept = stories(component, right);
        kept.remove(goal.index());
        kept.forEach(wrong::remove);
        return goal.index() + " " + mutant.mistake().what() + ": " + String.join(" ", wrong);
    }

    private static List<String> stories(Component component, Automaton automaton) {
        List<String> stories = new ArrayList<>();
        for (Automaton.Transition each : automaton.transitions()) {
            Graph alone = AutomatonGraph.of(component, automaton.withTransitions(List.of(each)));
            stories.add(
                    alone.roots().get(0).edges().stream()
                            .flatMap(edge -> edge.captions().stream())
                            .map(caption -> caption.mark().tooltip())
                            .filter(story -> !story.isEmpty())
                            .collect(Collectors.joining(" ")));
        }
        return stories;
    }
}

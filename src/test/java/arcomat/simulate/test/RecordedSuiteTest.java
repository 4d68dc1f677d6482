package arcomat.simulate.test;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Model;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.semantics.CoffeeFigures;
import arcomat.simulate.ModelText;
import arcomat.simulate.Runs;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.test.StreamTestResult.Verdict;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Recorded runs repeat themselves: those of the case study, and their text. */
class RecordedSuiteTest {
    private static final Path FOLDER = Path.of("models/coffee");

    @Test
    void aRunIsWrittenInSlicesWithRepetitions() {
        Component avoid = CoffeeFigures.figure3(Completion.IGNORE);
        Interpreter interpreter = new Interpreter(avoid, List.of(), Choice.ask(question -> 1));
        List<Letter> letters =
                Runs.letters(avoid, "frontUS=tooClose", "", "frontUS=clear", "frontUS=clear", "");
        Trace trace = Simulation.run(interpreter, letters);
        assertThat(RecordedSuite.of("Seen", trace, List.of(), interpreter.decisions()))
                .isEqualTo(
                        """
                        package coffee;

                        // 0: driving -> waiting (line 1), one of 2
                        testsuite Seen for AvoidCrash3 {
                          test recorded {
                            input {
                              frontUS: <tooClose, Tk, Tk, 2*(clear, Tk)>;
                            }
                            expect {
                              cmd: <fwd, Tk, stop, Tk, Tk, fwd, Tk, Tk>;
                            }
                          }
                        }
                        """);
    }

    @TestFactory
    Stream<DynamicTest> recordedRunsRepeatThemselves() {
        Model model = ModelText.read(FOLDER);
        return model.components().stream()
                .filter(component -> component.parameters().isEmpty() && !component.platform())
                .map(
                        component ->
                                DynamicTest.dynamicTest(
                                        component.qualifiedName(), () -> repeats(component)));
    }

    private static void repeats(Component component) {
        Interpreter interpreter = new Interpreter(component, List.of(), Choice.random(7));
        List<Letter> letters = Simulation.drawn(interpreter.network(), 7, 60).limit(40).toList();
        Trace trace = Simulation.run(interpreter, letters);
        String text = RecordedSuite.of("Recorded", trace, List.of(), interpreter.decisions());
        String path = component.packageName().replace('.', '/') + "/Recorded.mt";
        StreamTest test =
                ModelText.read(FOLDER, Map.of(path, text)).tests().stream()
                        .filter(t -> t.suite().endsWith("Recorded"))
                        .findFirst()
                        .orElseThrow();
        assertThat(StreamTests.run(test).verdict()).as(text).isNotEqualTo(Verdict.FAILED);
    }
}

package arcomat.analysis.contradiction;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Sections;
import arcomat.analysis.Verdicts;
import arcomat.analysis.contradiction.Consistency.Contradiction;
import arcomat.analysis.game.CounterStrategy.Turn;
import arcomat.analysis.game.Outcomes;
import arcomat.analysis.game.controller.ControllerChecks;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.model.Automaton;
import arcomat.model.Letter;
import arcomat.model.Model;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Contradictions as data: {@code verify/src/test/resources/analysis/contradictions}. Below {@code
 * == ask C} or {@code == ask-all C} stands the answer, below {@code fails} the contradictions with
 * their words, or step by step where the inputs depend on the outputs. Each is verified without the
 * engine.
 */
public class ContradictionsTest {
    private static final Path FOLDER = Path.of("verify/src/test/resources/analysis/contradictions");
    private static final Budget BUDGET = new Budget(() -> false, 100_000);

    @TestFactory
    Stream<DynamicTest> contradictions() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.sorted().toList().stream().flatMap(ContradictionsTest::ofFile);
        }
    }

    private static Stream<DynamicTest> ofFile(Path file) {
        Sections sections = Sections.read(file);
        Model model = sections.model();
        return sections.all().stream()
                .filter(each -> each.kind().startsWith("ask"))
                .map(
                        ask ->
                                DynamicTest.dynamicTest(
                                        file.getFileName() + " " + ask.kind() + " " + ask.rest(),
                                        () -> check(model, ask)));
    }

    private static void check(Model model, Sections.Section ask) {
        Promise promise = promise(model, ask.rest());
        Consistency found = Contradictions.check(promise, ask.kind().equals("ask-all"), BUDGET);
        String why =
                switch (ask.kind()) {
                    case "ask-why" -> why(found);
                    case "ask-explored" -> "\n" + found.explored() + " positions";
                    default -> "";
                };
        assertThat(text(found) + why).isEqualTo(String.join("\n", ask.lines()));
        assertThat(found.answer() == Answer.FAILS).isEqualTo(!found.contradictions().isEmpty());
        found.contradictions().forEach(each -> verify(promise, each));
        found.controller().ifPresent(each -> ControllerChecks.check(promise, each));
    }

    private static Promise promise(Model model, String name) {
        var component = model.component(name).orElseThrow();
        return component.isComposite()
                ? Promise.required(component, List.of())
                : Promise.of(component, List.of());
    }

    /** What the engine says about a contradiction, without the engine. */
    public static void verify(Promise promise, Contradiction contradiction) {
        Outcomes outcomes = new Outcomes(each(promise, contradiction.requirements()));
        contradiction
                .word()
                .ifPresent(
                        word -> {
                            assertThat(outcomes.somethingComplies(word)).isFalse();
                            for (int i = 0; i < word.size(); i++) {
                                assertThat(outcomes.somethingComplies(word.subList(0, i))).isTrue();
                            }
                        });
        int depth = depth(contradiction, 0);
        assertThat(outcomes.isLost(depth)).isTrue();
        if (contradiction.word().isEmpty() && depth > 0) {
            assertThat(outcomes.isLost(depth - 1)).as("in fewer inputs").isFalse();
        }
        if (contradiction.minimal()) {
            for (Automaton needless : contradiction.requirements()) {
                List<Automaton> rest = new ArrayList<>(contradiction.requirements());
                rest.remove(needless);
                assertThat(new Outcomes(each(promise, rest)).isLost(depth)).isFalse();
            }
        }
    }

    private static List<Promise> each(Promise promise, List<Automaton> automata) {
        return automata.stream()
                .map(a -> new Promise(promise.component(), promise.arguments(), List.of(a)))
                .toList();
    }

    private static int depth(Contradiction contradiction, int step) {
        int depth = 0;
        for (Turn.Answer answer : contradiction.steps().get(step).answers()) {
            depth = Math.max(depth, 1 + depth(contradiction, answer.next()));
        }
        return depth;
    }

    private static String text(Consistency found) {
        List<String> lines = new ArrayList<>();
        String answer = found.answer().name().toLowerCase(Locale.ROOT);
        lines.add((answer + " " + found.reason()).strip());
        for (Contradiction each : found.contradictions()) {
            String names =
                    each.requirements().stream()
                            .map(Automaton::name)
                            .collect(Collectors.joining(", "));
            String word = each.word().map(ContradictionsTest::word).orElse("no single word");
            lines.add(names + (each.minimal() ? ": " : " (perhaps fewer): ") + word);
            if (each.word().isEmpty()) {
                lines.addAll(steps(each));
            }
        }
        found.notes().forEach(lines::add);
        return String.join("\n", lines);
    }

    /** What is asked for where no answer is left. */
    private static String why(Consistency found) {
        return found.contradictions().stream()
                .flatMap(each -> each.steps().stream())
                .flatMap(step -> step.demands().stream())
                .map(sentence -> "\n" + sentence.text())
                .collect(Collectors.joining());
    }

    private static String word(List<Letter> word) {
        return word.isEmpty()
                ? "at the beginning"
                : word.stream().map(ContradictionsTest::letter).collect(Collectors.joining(" "));
    }

    private static String letter(Letter letter) {
        return Verdicts.trace(List.of(new Moment(letter, java.util.Map.of(), "", List.of())))
                .replace("/{}", "");
    }

    private static List<String> steps(Contradiction contradiction) {
        List<String> lines = new ArrayList<>();
        for (int i = 0; i < contradiction.steps().size(); i++) {
            Contradiction.Step step = contradiction.steps().get(i);
            List<String> answers = new ArrayList<>();
            for (Turn.Answer answer : step.answers()) {
                Moment moment = new Moment(Letter.SILENCE, answer.outputs(), "", List.of());
                answers.add(
                        Verdicts.trace(List.of(moment)).replace("{}/", "")
                                + " -> "
                                + answer.next());
            }
            lines.add(i + ": " + letter(step.input()) + " / " + String.join(", ", answers));
        }
        return lines.stream().map(String::strip).toList();
    }
}

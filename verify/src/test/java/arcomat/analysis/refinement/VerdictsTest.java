package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Replay;
import arcomat.analysis.Sections;
import arcomat.analysis.Verdicts;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * Verdicts as data: {@code verify/src/test/resources/analysis/refinement}. Below {@code == ask A
 * B}, or {@code == ask A !B} for what automata on a decomposed component ask for, a line names the
 * completions of both sides, {@code -} for those of the models, and what is to be answered: {@code
 * holds}, with a part of a note if one is expected, or {@code simulates}, {@code does not simulate}
 * or {@code may simulate}, or how much was explored, {@code fails}, with the whole trace, or behind
 * {@code says} all sentences, or a part of the reason and the note, {@code not late} where there is
 * none, or {@code unknown}.
 */
public class VerdictsTest {
    public static final Path FOLDER = Path.of("verify/src/test/resources/analysis/refinement");

    private static final Map<String, Completion> COMPLETIONS =
            Map.of(
                    "c", Completion.CHAOS,
                    "o", Completion.OUTPUT,
                    "i", Completion.IGNORE,
                    "e", Completion.ERROR);

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> verdicts() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.sorted().toList().stream().flatMap(VerdictsTest::ofFile);
        }
    }

    private static Stream<DynamicTest> ofFile(Path file) {
        Sections sections = Sections.read(file);
        Model model = sections.model();
        return sections.of("ask").stream()
                .flatMap(
                        ask ->
                                ask.lines().stream()
                                        .map(
                                                line ->
                                                        DynamicTest.dynamicTest(
                                                                file.getFileName()
                                                                        + " "
                                                                        + ask.rest()
                                                                        + " "
                                                                        + line,
                                                                () ->
                                                                        check(
                                                                                model,
                                                                                ask.rest(),
                                                                                line))));
    }

    private static void check(Model model, String sides, String line) {
        String[] names = sides.split(" ");
        String[] words = line.split(" ", 2);
        Promise left = promise(model, names[0], words[0].charAt(0));
        Promise right = promise(model, names[1], words[0].charAt(words[0].length() - 1));
        Verdict verdict = Refinement.check(left, right, new Budget(() -> false, 100_000));
        assertThat(Verdicts.text(verdict, words[1])).isEqualTo(words[1]);
        if (!verdict.trace().isEmpty()) {
            Replay.check(left, right, verdict);
        }
        if (verdict.answer() == Verdict.Answer.HOLDS) {
            Certification proof = Certification.of(left, right, new Budget(() -> false, 100_000));
            assertThat(proof.verdict().answer()).isEqualTo(Verdict.Answer.HOLDS);
            assertThat(Certification.problem(left, right, proof.certificates(), Budget.ofMemory()))
                    .isEmpty();
        }
    }

    public static Promise promise(Model model, String name, char completion) {
        boolean required = name.startsWith("!");
        String[] parts = name.substring(required ? 1 : 0).split("#");
        Component component = model.component(parts[0]).orElseThrow();
        Promise all =
                required
                        ? Promise.required(component, List.of())
                        : Promise.of(component, List.of());
        Promise promise = parts.length > 1 ? all.only(parts[1]).orElseThrow() : all;
        return completion == '-'
                ? promise
                : promise.with(COMPLETIONS.get(String.valueOf(completion)));
    }
}

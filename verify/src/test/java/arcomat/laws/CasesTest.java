package arcomat.laws;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.contradiction.Consistency;
import arcomat.analysis.contradiction.Contradictions;
import arcomat.analysis.refinement.Difference;
import arcomat.analysis.refinement.Verdict;
import arcomat.laws.Law.Outcome;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.StreamTest;
import arcomat.models.ModelFiles;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.simulate.test.StreamTests;
import arcomat.source.SourceFile;

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
 * Cases that have to come out right: {@code src/test/resources/laws}. Models stand behind lines
 * {@code -- PATH}, or are those of a folder, {@code -- models FOLDER}. Above them each line {@code
 * // COMMAND: ANSWER} is a test; other comments say what the case is about.
 *
 * <ul>
 *   <li>{@code refines A B: holds}, {@code fails}, {@code fails (delay)}, {@code fails (behaviour)
 *       after 2 inputs}, {@code unknown}; B may be {@code R#one}, an automaton of several. The
 *       reference is asked, too.
 *   <li>{@code verify D: ...}, the parts of a component against its automata.
 *   <li>{@code diff A B: equivalent}, {@code refines}, {@code is_refined_by}, {@code incomparable}.
 *   <li>{@code contradictions R: holds}, {@code fails}; a controller refines.
 *   <li>{@code test Suite.name: passed}, {@code vacuous}, {@code failed}, {@code failed 3}, in
 *       which slice.
 * </ul>
 */
class CasesTest {
    private static final Path FOLDER = Path.of("verify/src/test/resources/laws");

    @TestFactory
    Stream<DynamicTest> cases() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.sorted().toList().stream().flatMap(CasesTest::ofFile);
        }
    }

    private static Stream<DynamicTest> ofFile(Path file) {
        try {
            List<String> lines = Files.readAllLines(file);
            Model model = ReadModels.model(sources(lines));
            return lines.stream()
                    .takeWhile(line -> line.startsWith("//"))
                    .map(line -> line.substring(2).strip())
                    .filter(
                            line ->
                                    line.matches(
                                            "(refines|verify|diff|contradictions|test) .*: .*"))
                    .map(
                            line ->
                                    DynamicTest.dynamicTest(
                                            file.getFileName() + " " + line,
                                            () -> check(model, line)));
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    private static List<SourceFile> sources(List<String> lines) {
        List<SourceFile> sources = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i).startsWith("-- models ")) {
                sources.addAll(ModelFiles.of(Path.of(lines.get(i).substring(10))));
            } else if (lines.get(i).startsWith("-- ")) {
                String text =
                        lines.subList(i + 1, lines.size()).stream()
                                .takeWhile(line -> !line.startsWith("-- "))
                                .collect(Collectors.joining("\n", "", "\n"));
                sources.add(new SourceFile(lines.get(i).substring(3), text));
            }
        }
        return sources;
    }

    private static void check(Model model, String line) {
        int colon = line.indexOf(": ");
        String[] command = line.substring(0, colon).split(" ");
        String expected = line.substring(colon + 2);
        switch (command[0]) {
            case "refines" ->
                    refines(promise(model, command[1]), promise(model, command[2]), expected);
            case "verify" -> {
                Component component = model.component(command[1]).orElseThrow();
                refines(
                        Questions.promise(component),
                        Promise.required(component, List.of()),
                        expected);
            }
            case "diff" ->
                    assertThat(
                                    Difference.of(
                                                    promise(model, command[1]),
                                                    promise(model, command[2]),
                                                    Questions.budget())
                                            .relation()
                                            .name()
                                            .toLowerCase(Locale.ROOT))
                            .isEqualTo(expected);
            case "contradictions" -> contradictions(promise(model, command[1]), expected);
            default -> test(model, command[1], expected);
        }
    }

    private static Promise promise(Model model, String name) {
        String[] parts = name.split("#");
        Promise all = Questions.promise(model.component(parts[0]).orElseThrow());
        return parts.length == 1 ? all : all.only(parts[1]).orElseThrow();
    }

    private static void refines(Promise left, Promise right, String expected) {
        Verdict verdict = Questions.refines(left, right);
        assertThat(Questions.text(verdict)).startsWith(expected);
        Outcome reference = AsTheReference.check(left, right, "");
        assertThat(reference.problem()).isEmpty();
    }

    private static void contradictions(Promise promise, String expected) {
        Consistency found = Contradictions.check(promise, true, Questions.budget());
        assertThat(found.answer().name().toLowerCase(Locale.ROOT)).isEqualTo(expected);
        found.controller()
                .ifPresent(controller -> refines(Questions.promise(controller), promise, "holds"));
    }

    private static void test(Model model, String name, String expected) {
        StreamTest test =
                model.tests().stream()
                        .filter(each -> (each.suite() + "." + each.name()).equals(name))
                        .findFirst()
                        .orElseThrow();
        var result = StreamTests.run(test);
        String said = result.verdict().name().toLowerCase(Locale.ROOT);
        String slice =
                result.firstDifference().isPresent()
                        ? " " + result.firstDifference().getAsInt()
                        : "";
        assertThat(said + slice).startsWith(expected);
    }
}

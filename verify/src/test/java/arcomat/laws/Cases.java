package arcomat.laws;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.contradiction.Consistency;
import arcomat.analysis.contradiction.Contradictions;
import arcomat.analysis.refinement.Difference;
import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Verdict;
import arcomat.generate.plan.Choosing;
import arcomat.laws.Law.Outcome;
import arcomat.model.Component;
import arcomat.model.Invariant;
import arcomat.model.Letter;
import arcomat.model.Model;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.models.ModelFiles;
import arcomat.models.ReadModels;
import arcomat.pipeline.compile.CompiledExecution;
import arcomat.pipeline.compile.CompiledModel;
import arcomat.rt.ModelError;
import arcomat.semantics.Execution;
import arcomat.semantics.Promise;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.test.StreamTests;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * Models with what commands have to say about them, in one file. Models stand behind lines {@code
 * -- PATH}, or are those of a folder, {@code -- models FOLDER}. Above them each line {@code //
 * COMMAND: ANSWER} is a case; other comments say what the case is about.
 *
 * <ul>
 *   <li>{@code refines A B: holds}, {@code fails}, {@code fails (delay)}, {@code fails (behaviour)
 *       after 2 inputs}, {@code unknown}; B may be {@code R#one}, an automaton of several. The
 *       reference is asked, too.
 *   <li>{@code verify D: ...}, the parts of a component against its automata.
 *   <li>{@code keeps C.invariant: holds}, {@code fails}; the reference is asked, too.
 *   <li>{@code diff A B: equivalent}, {@code refines}, {@code is_refined_by}, {@code incomparable}.
 *   <li>{@code contradictions R: holds}, {@code fails}; a controller refines.
 *   <li>{@code test Suite.name: passed}, {@code vacuous}, {@code failed}, {@code failed 3}, in
 *       which slice.
 *   <li>{@code simulate Suite.name: transition 1, ignore, error}, what is done in each slice of the
 *       input of a test, by the interpreter as well as by compiled code.
 * </ul>
 */
record Cases(List<String> lines, Model model) {
    private static final String COMMANDS =
            "(refines|verify|keeps|diff|contradictions|test|simulate) .*: .*";

    static Cases read(Path file) throws IOException {
        List<String> lines = Files.readAllLines(file);
        return new Cases(lines, ReadModels.model(sources(lines)));
    }

    /** Whether a line above the models is a case. */
    static boolean isCase(String line) {
        return line.matches(COMMANDS);
    }

    /** The lines above the models, without their marks. */
    List<String> head() {
        return lines.stream()
                .takeWhile(line -> line.startsWith("//"))
                .map(line -> line.substring(2).strip())
                .toList();
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

    void check(String line) {
        int colon = line.indexOf(": ");
        String[] command = line.substring(0, colon).split(" ");
        String expected = line.substring(colon + 2);
        switch (command[0]) {
            case "refines" -> refines(promise(command[1]), promise(command[2]), expected);
            case "verify" -> {
                Component component = component(command[1]);
                Promise required = Promise.required(component, List.of());
                refines(Questions.promise(component), required, expected);
            }
            case "keeps" -> keeps(command[1], expected);
            case "diff" -> diff(promise(command[1]), promise(command[2]), expected);
            case "contradictions" -> contradictions(promise(command[1]), expected);
            case "simulate" -> simulate(test(command[1]), expected);
            default -> test(test(command[1]), expected);
        }
    }

    private Component component(String name) {
        return model.component(name).orElseThrow();
    }

    private Promise promise(String name) {
        String[] parts = name.split("#");
        Promise all = Questions.promise(component(parts[0]));
        return parts.length == 1 ? all : all.only(parts[1]).orElseThrow();
    }

    private StreamTest test(String name) {
        return model.tests().stream()
                .filter(each -> (each.suite() + "." + each.name()).equals(name))
                .findFirst()
                .orElseThrow();
    }

    private static void refines(Promise left, Promise right, String expected) {
        Verdict verdict = Questions.refines(left, right);
        assertThat(Questions.text(verdict)).startsWith(expected);
        Outcome reference = AsTheReference.check(left, right, "");
        assertThat(reference.problem()).isEmpty();
    }

    private void keeps(String name, String expected) {
        int dot = name.lastIndexOf('.');
        Component component = component(name.substring(0, dot));
        Invariant invariant =
                component.invariants().stream()
                        .filter(each -> each.name().equals(name.substring(dot + 1)))
                        .findFirst()
                        .orElseThrow();
        Verdict verdict = InvariantProof.check(component, List.of(), invariant, Questions.budget());
        assertThat(Questions.text(verdict)).startsWith(expected);
        Outcome reference = InvariantsAsTheReference.asTheReference(component, invariant, verdict);
        assertThat(reference.problem()).isEmpty();
    }

    private static void diff(Promise one, Promise other, String expected) {
        Difference difference = Difference.of(one, other, Questions.budget());
        assertThat(difference.relation().name().toLowerCase(Locale.ROOT)).isEqualTo(expected);
    }

    private static void contradictions(Promise promise, String expected) {
        Consistency found = Contradictions.check(promise, true, Questions.budget());
        assertThat(found.answer().name().toLowerCase(Locale.ROOT)).isEqualTo(expected);
        found.controller()
                .ifPresent(controller -> refines(Questions.promise(controller), promise, "holds"));
    }

    private static void test(StreamTest test, String expected) {
        var result = StreamTests.run(test);
        String said = result.verdict().name().toLowerCase(Locale.ROOT);
        String slice =
                result.firstDifference().isPresent()
                        ? " " + result.firstDifference().getAsInt()
                        : "";
        assertThat(said + slice).startsWith(expected);
    }

    private static void simulate(StreamTest test, String expected) {
        Component component = test.component();
        CompiledModel compiled = CompiledModel.of(component, Choosing.FIRST);
        List<Execution> engines =
                List.of(
                        new Interpreter(component, test.arguments(), Choice.first()),
                        new CompiledExecution(compiled, test.arguments(), 0));
        List<List<Object>> steps =
                engines.stream().map(engine -> steps(engine, test.inputs())).toList();
        assertThat(steps.get(1)).isEqualTo(steps.get(0));
        assertThat(steps.get(0).stream().map(Cases::text).collect(Collectors.joining(", ")))
                .isEqualTo(expected);
    }

    /** Steps, and the message of the error in which the run ends. */
    private static List<Object> steps(Execution engine, List<Letter> word) {
        List<Object> steps = new ArrayList<>();
        try {
            word.forEach(letter -> steps.add(engine.step(letter)));
        } catch (ModelError problem) {
            steps.add(String.valueOf(problem.getMessage()));
        }
        return steps;
    }

    private static String text(Object step) {
        return step instanceof Trace.Step done
                ? done.activities().stream()
                        .map(each -> text(each.cause()))
                        .collect(Collectors.joining(" and "))
                : "error";
    }

    private static String text(Trace.Cause cause) {
        return cause instanceof Trace.Taken taken
                ? "transition " + (taken.index() + 1)
                : ((Trace.Completed) cause).completion().name().toLowerCase(Locale.ROOT);
    }
}

package arcomat.pipeline.analysis;

import arcomat.analysis.coverage.Goal;
import arcomat.analysis.coverage.TransitionTests;
import arcomat.analysis.refinement.Promise;
import arcomat.model.Component;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.PromiseReference;
import arcomat.pipeline.file.OutputFolder;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;
import arcomat.rt.ModelError;
import arcomat.simulate.test.SuiteText;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.Formatter;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** Writes a suite of stream tests that takes every transition. */
public final class TransitionTestsStep {
    private TransitionTestsStep() {}

    public static TransitionTestsResult run(
            TransitionTestsRequest request, List<String> paths, PathNames names, Progress progress)
            throws WrongUse {
        CheckedModels checked =
                CheckedModels.checkToExamine(
                        paths, Asked.components(List.of(request.component())), names, progress);
        if (checked.hasErrors()) {
            return new TransitionTestsResult(checked.result(), Optional.empty(), "", "");
        }
        Promise promise =
                PromiseReference.parse(request.component()).in(checked, checked.lower(progress));
        requireBehaviour(promise.component());
        String suite = suite(promise.component());
        progress.step("looking for tests");
        TransitionTests.Result found = find(promise, suite, request);
        if (found.tests().isEmpty()) {
            return new TransitionTestsResult(
                    checked.result(), Optional.of(found), promise.title(), "");
        }
        String folder = promise.component().packageName().replace('.', '/');
        String file = (folder.isEmpty() ? "" : folder + "/") + suite + ".mt";
        byte[] text = text(file, suite, promise, found).getBytes(StandardCharsets.UTF_8);
        OutputFolder.replace(names.resolve(request.out()), request.out(), Map.of(file, text));
        return new TransitionTestsResult(
                checked.result(), Optional.of(found), promise.title(), request.out() + "/" + file);
    }

    private static TransitionTests.Result find(
            Promise promise, String suite, TransitionTestsRequest request) throws WrongUse {
        try {
            return TransitionTests.of(promise, suite, request.limits().budget());
        } catch (ModelError error) {
            throw new WrongUse(
                    "the model goes wrong before it reads anything: " + error.getMessage());
        }
    }

    private static void requireBehaviour(Component component) throws WrongUse {
        String name = "component '" + component.qualifiedName() + "'";
        if (component.isComposite()) {
            throw new WrongUse(
                    name
                            + " is decomposed, and tests are made from the transitions of one"
                            + " automaton; name one of its parts");
        }
        if (component.platform() || Promise.of(component, List.of()).automata().isEmpty()) {
            throw new WrongUse(name + " has no automaton, so there is nothing to take");
        }
        if (component.name().contains("<")) {
            throw new WrongUse(name + " has type arguments, which no suite can name");
        }
    }

    /** The name of the suite: what is tested, and how. */
    private static String suite(Component component) {
        return component.name().replace(".", "") + "Transitions";
    }

    private static String text(
            String file, String suite, Promise promise, TransitionTests.Result found) {
        List<String> remarks = new ArrayList<>();
        int taken = found.transitions() - found.uncovered().size();
        remarks.add(
                "Made by arcomat tests: %d of %d transitions of %s are taken."
                        .formatted(taken, found.transitions(), promise.title()));
        found.uncovered()
                .forEach(
                        each ->
                                remarks.add(
                                        "Not taken: "
                                                + line(each.transition())
                                                + ": "
                                                + each.reason()));
        found.gaps()
                .forEach(
                        each ->
                                remarks.add(
                                        (each.certain() ? "Not told: if " : "Perhaps not told: if ")
                                                + line(each.transition())
                                                + " "
                                                + each.words()
                                                + ": "
                                                + each.reason()));
        if (promise.component().profile() == Component.Profile.EVENT_DRIVEN) {
            remarks.add("Small mistakes in transitions are not looked for among events.");
        }
        List<SuiteText.Entry> entries = new ArrayList<>();
        for (TransitionTests.Test test : found.tests()) {
            entries.add(new SuiteText.Entry(purpose(test), test.streams()));
        }
        String text =
                SuiteText.of(suite, promise.component(), promise.arguments(), remarks, entries);
        return Formatter.format(new SourceFile(file, text)).text().orElse(text);
    }

    private static List<String> purpose(TransitionTests.Test test) {
        String end = test.promised() ? "" : ", seen where the model promises nothing any more";
        return Stream.concat(
                        test.covers().stream().map(TransitionTestsStep::line),
                        test.tells().stream().map(each -> "if " + mistake(each) + end))
                .toList();
    }

    /** {@code line 22: driving -> waiting leads to 'backing'}. */
    private static String mistake(TransitionTests.Mistake mistake) {
        return line(mistake.transition()) + " " + mistake.what();
    }

    /** {@code line 22: driving -> waiting}. */
    private static String line(Goal goal) {
        Span span = goal.transition().span();
        return "line "
                + span.startPosition().line()
                + ": "
                + goal.source()
                + " -> "
                + goal.target();
    }
}

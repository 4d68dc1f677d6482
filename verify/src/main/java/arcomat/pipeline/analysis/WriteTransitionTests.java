package arcomat.pipeline.analysis;

import arcomat.analysis.coverage.Goal;
import arcomat.analysis.coverage.TransitionTests;
import arcomat.model.Component;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.pipeline.check.PromiseReference;
import arcomat.pipeline.file.OutputFolder;
import arcomat.rt.ModelError;
import arcomat.semantics.Promise;
import arcomat.simulate.test.SuiteText;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.Formatter;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * Writes a suite of stream tests that takes every transition.
 *
 * @param component as written: {@code p.Timer(2)}, or {@code p.Robot#waits} for the transitions of
 *     one automaton
 * @param out the folder to write, which is replaced as a whole
 */
public record WriteTransitionTests(
        String component, String out, List<String> paths, AnalysisLimits limits)
        implements ModelQuestion<WriteTransitionTests.Made> {
    /**
     * What came of it.
     *
     * @param title what the tests are for
     * @param file path of the suite in the output folder; empty where there is no test to write
     */
    public record Made(TransitionTests.Result tests, String title, String file) {}

    @Override
    public Asked asked() {
        return Asked.components(List.of(component));
    }

    /**
     * @throws WrongUse where there is no such component, or the folder cannot be written
     */
    @Override
    public Made answer(LoweredModels models, Session session) throws WrongUse {
        Promise promise = PromiseReference.parse(component).in(models);
        requireBehaviour(promise.component());
        String suite = suite(promise.component());
        session.progress().step("looking for tests");
        TransitionTests.Result found = find(promise, suite);
        if (found.tests().isEmpty()) {
            return new Made(found, promise.title(), "");
        }
        String folder = promise.component().packageName().replace('.', '/');
        String file = (folder.isEmpty() ? "" : folder + "/") + suite + ".mt";
        String text = text(file, suite, promise, found);
        OutputFolder.replaceTexts(out, Map.of(file, text), session.names());
        return new Made(found, promise.title(), out + "/" + file);
    }

    private TransitionTests.Result find(Promise promise, String suite) throws WrongUse {
        try {
            return TransitionTests.of(promise, suite, limits.budget());
        } catch (ModelError error) {
            throw new WrongUse(
                    "the model goes wrong before it reads anything: " + error.getMessage());
        }
    }

    private static void requireBehaviour(Component component) throws WrongUse {
        String name = "component '" + component.qualifiedName() + "'";
        if (component.isComposite()) {
            throw new WrongUse(
                    "%s is decomposed, and tests are made from the transitions of one automaton;"
                            + " name one of its parts",
                    name);
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
                                        "Not taken: %s: %s"
                                                .formatted(
                                                        line(each.transition()), each.reason())));
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
                        test.covers().stream().map(WriteTransitionTests::line),
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
        return "line %s: %s -> %s"
                .formatted(span.startPosition().line(), goal.source(), goal.target());
    }
}

package arcomat.pipeline.simulate;

import arcomat.model.Model;
import arcomat.model.StreamTest;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;

import java.util.ArrayList;
import java.util.List;

/** Runs the stream tests of the files that were named, in the order of the text. */
public final class TestStep {
    private TestStep() {}

    public static TestResult run(List<String> paths, PathNames names, Progress progress)
            throws WrongUse {
        CheckedModels checked =
                CheckedModels.checkToRun(
                        paths,
                        whole -> !whole.testSuites().isEmpty(),
                        models -> List.of(),
                        names,
                        progress);
        if (checked.hasErrors()) {
            return new TestResult(checked.result(), List.of());
        }
        Model model = checked.lower(progress);
        List<StreamTest> tests =
                model.tests().stream()
                        .filter(t -> checked.loaded().isNamedByUser(t.span().file().path()))
                        .toList();
        if (tests.isEmpty()) {
            throw new WrongUse("there are no stream tests (.mt) in " + String.join(", ", paths));
        }
        List<StreamTestResult> results = new ArrayList<>();
        for (StreamTest test : tests) {
            progress.step("running " + test.suite() + "#" + test.name());
            results.add(StreamTests.run(test));
        }
        return new TestResult(checked.result(), results);
    }
}

package arcomat.pipeline.simulate;

import arcomat.model.StreamTest;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;

import java.util.ArrayList;
import java.util.List;

/** Runs the stream tests of the files that were named, in the order of the text. */
public record RunStreamTests(List<String> paths) implements ModelQuestion<List<StreamTestResult>> {
    @Override
    public Asked asked() {
        return whole -> !whole.testSuites().isEmpty();
    }

    /**
     * @throws WrongUse where there are none
     */
    @Override
    public List<StreamTestResult> answer(LoweredModels models, Session session) throws WrongUse {
        List<StreamTest> tests =
                models.model().tests().stream().filter(t -> models.isNamed(t.span())).toList();
        if (tests.isEmpty()) {
            throw new WrongUse("there are no stream tests (.mt) in " + String.join(", ", paths));
        }
        List<StreamTestResult> results = new ArrayList<>();
        for (StreamTest test : tests) {
            session.progress().goOn();
            session.progress().step("running " + test.title());
            results.add(StreamTests.run(test));
        }
        return results;
    }
}

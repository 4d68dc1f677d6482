package arcomat.pipeline.watch;

import arcomat.model.StreamTest;
import arcomat.pipeline.Session;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Runs the tests of some suites.
 *
 * @param paths the suites, and all files that they need
 * @param suites as they are shown
 */
record RunSuites(List<String> paths, Set<String> suites)
        implements ModelQuestion<List<StreamTestResult>> {
    @Override
    public Asked asked() {
        return Asked.WHAT_IS_WHOLE;
    }

    @Override
    public List<StreamTestResult> answer(LoweredModels models, Session session) {
        List<StreamTestResult> results = new ArrayList<>();
        for (StreamTest test : models.model().tests()) {
            if (suites.contains(test.span().file().path())) {
                session.progress().goOn();
                results.add(StreamTests.run(test));
            }
        }
        return results;
    }
}

package arcomat.check.tests;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.tree.Name;
import arcomat.tree.TestSuite;

import java.util.HashMap;
import java.util.Map;

/** ARC0704: the tests of a suite differ in name. */
public final class TestNamesUnique implements Check.OnTestSuite {

    @Override
    public Law law() {
        return Law.error("ARC0704");
    }

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        Map<String, Name> seen = new HashMap<>();
        for (TestSuite.Test test : Tests.of(suite.node())) {
            Name first = seen.putIfAbsent(test.name().text(), test.name());
            if (first != null) {
                findings.report(
                                test.name(),
                                "suite '"
                                        + suite.name()
                                        + "' has two tests named '"
                                        + test.name()
                                        + "'; rename one")
                        .related(first, "the other one is here");
            }
        }
    }
}

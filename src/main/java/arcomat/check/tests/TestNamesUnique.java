package arcomat.check.tests;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.TestSuiteSymbol;

/** ARC0704: the tests of a suite differ in name. */
public final class TestNamesUnique implements Check.OnTestSuite {

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        Duplicates.report(
                suite.tests().stream().map(test -> test.node().name()).toList(),
                findings,
                "suite '%s' has two tests named '%s'; rename one",
                suite.name(),
                "the other one is here");
    }
}

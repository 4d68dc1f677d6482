package arcomat.check.tests;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.tree.TestSuite;

/** ARC0704: the tests of a suite differ in name. */
public final class TestNamesUnique implements Check.OnTestSuite {

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        Duplicates.report(
                Tests.of(suite.node()).stream().map(TestSuite.Test::name).toList(),
                (name, first) ->
                        findings.report(
                                        name,
                                        "suite '%s' has two tests named '%s'; rename one",
                                        suite.name(),
                                        name)
                                .related(first, "the other one is here"));
    }
}

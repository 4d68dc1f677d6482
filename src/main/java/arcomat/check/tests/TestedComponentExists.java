package arcomat.check.tests;

import arcomat.check.facts.UnresolvedComponents;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;

/** ARC0701: the component that a suite is for exists and is unambiguous. */
public final class TestedComponentExists implements Check.OnTestSuite {

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        UnresolvedComponents.check(
                suite.node().component(),
                suite.component().map(ComponentSymbol::signature),
                context,
                findings);
    }
}

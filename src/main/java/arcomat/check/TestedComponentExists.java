package arcomat.check;

import arcomat.symbols.TestSuiteSymbol;

/** ARC0701: the component that a suite is for exists and is unambiguous. */
final class TestedComponentExists implements Check.OnTestSuite {

    @Override
    public Law law() {
        return Law.error("ARC0701");
    }

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        ComponentNames.check(suite.node().component(), suite.component(), context, findings);
    }
}

package arcomat.check.tests;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.tree.TestSuite;

/** ARC0708: fields and Java blocks of the suites of 2012 are kept and have no effect. */
public final class TestFieldUnsupported implements Check.OnTestSuite {

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        for (TestSuite.Member member : suite.node().members()) {
            if (member instanceof TestSuite.Field) {
                findings.report(
                        member,
                        "fields of test suites are not used; give the tested component its values"
                                + " as arguments, as in 'for %s(3)'",
                        suite.node().component());
            }
            for (TestSuite.Before before : member.before()) {
                findings.report(
                        before.name(),
                        "the Java block '@%s' is not run; say what should happen before with"
                                + " messages in the first slices",
                        before.name());
            }
        }
    }
}

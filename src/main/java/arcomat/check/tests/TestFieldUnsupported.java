package arcomat.check.tests;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.tree.TestSuite;
import arcomat.tree.Variable;

import java.util.List;

/** ARC0708: fields without a known value and Java blocks of the suites of 2012 have no effect. */
public final class TestFieldUnsupported implements Check.OnTestSuite {

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        for (TestSuite.Member member : suite.node().members()) {
            if (member instanceof TestSuite.Field field && !isKnown(field, suite)) {
                findings.report(
                        member,
                        "nobody knows the value of this field before the tests are run, so it is"
                                + " not used; give it a literal that no Java block changes, or give"
                                + " the tested component its values as arguments, as in"
                                + " 'for %s(3)'",
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

    private static boolean isKnown(TestSuite.Field field, TestSuiteSymbol suite) {
        List<Variable> known = suite.fields().stream().map(VariableSymbol::node).toList();
        return known.containsAll(field.variables());
    }
}

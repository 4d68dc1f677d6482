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
                report(field, suite, findings);
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

    private static void report(TestSuite.Field field, TestSuiteSymbol suite, Findings findings) {
        if (isNamed(field, suite)) {
            String name = field.variables().get(0).name().text();
            findings.report(
                    field,
                    "whatever Java gives this field, it stands for a message of its own, as if"
                            + " '%s(\"%s\")' were written; fields that should be equal are one"
                            + " field",
                    field.type().name(),
                    name);
            return;
        }
        findings.report(
                field,
                "nobody knows the value of this field before the tests are run, so it is not used;"
                        + " give it a literal that no Java block changes, or give the tested"
                        + " component its values as arguments, as in 'for %s(3)'",
                suite.node().component());
    }

    private static boolean isKnown(TestSuite.Field field, TestSuiteSymbol suite) {
        List<Variable> known = suite.fields().stream().map(VariableSymbol::node).toList();
        return known.containsAll(field.variables());
    }

    /** Whether each is a message that is known by its name alone. */
    private static boolean isNamed(TestSuite.Field field, TestSuiteSymbol suite) {
        List<String> known = suite.fields().stream().map(VariableSymbol::name).toList();
        return field.variables().stream().map(each -> each.name().text()).allMatch(known::contains);
    }
}

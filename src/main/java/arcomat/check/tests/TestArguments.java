package arcomat.check.tests;

import arcomat.check.behaviour.item.Items;
import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.check.structure.component.ArgumentCount;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.Typed;

import java.util.List;

/** ARC0705: a tested component gets a value for each of its parameters, and needs no types. */
public final class TestArguments implements Check.OnTestSuite {

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        suite.component().found().ifPresent(component -> check(suite, component, findings));
    }

    private static void check(TestSuiteSymbol suite, ComponentSymbol component, Findings findings) {
        if (component.signature().isGeneric()) {
            findings.report(
                            suite.node().component(),
                            "component '%s' needs type arguments, which a suite cannot give; test a"
                                    + " component that uses it with given types",
                            component.name())
                    .related(component.nameSpan(), "declared with type parameters");
            return;
        }
        List<ParameterSymbol> parameters = component.parameters();
        reportMissing(suite, component, findings);
        for (GivenArgument argument : suite.arguments()) {
            if (argument.parameter().isEmpty() && !argument.isLost()) {
                findings.report(
                        argument.node(),
                        "component '%s' has %s; remove this argument",
                        component.name(),
                        parameters.isEmpty()
                                ? "no parameters"
                                : Wording.count(parameters.size(), "parameter"));
            }
            argument.parameter()
                    .filter(parameter -> !argument.value().isAssignableTo(parameter.type()))
                    .ifPresent(parameter -> reportType(argument.value(), parameter, findings));
        }
    }

    private static void reportMissing(
            TestSuiteSymbol suite, ComponentSymbol component, Findings findings) {
        List<String> missing = ArgumentCount.missing(component.parameters(), suite.arguments());
        if (!missing.isEmpty()) {
            findings.report(
                            suite.node().component(),
                            "component '%s' needs a value for %s; write it in parentheses behind"
                                    + " the name",
                            component.name(),
                            Wording.quoted(missing))
                    .related(component.nameSpan(), "declared with parameters");
        }
    }

    private static void reportType(Typed argument, ParameterSymbol parameter, Findings findings) {
        findings.report(
                        argument.expression().node(),
                        "%s takes %s",
                        Items.words(parameter),
                        Wording.mismatch(parameter.type(), argument))
                .related(parameter.nameSpan(), "declared here");
    }
}

package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Name;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * ARC0134: an argument with a name is for a parameter of that name, which has no other; arguments
 * without names, whose places tell their parameters, come before those with names.
 */
public final class ArgumentNamesParameter
        implements Check.OnComponent, Check.OnInstance, Check.OnTestSuite {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Signature heir = component.signature();
        heir.superComponent()
                .flatMap(ComponentReference::component)
                .ifPresent(above -> check(above, heir.superArguments(), findings));
    }

    @Override
    public void check(InstanceSymbol instance, Context context, Findings findings) {
        instance.component()
                .ifPresent(type -> check(type.signature(), instance.arguments(), findings));
    }

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        suite.component()
                .found()
                .ifPresent(type -> check(type.signature(), suite.arguments(), findings));
    }

    private static void check(
            Signature component, List<GivenArgument> arguments, Findings findings) {
        boolean named = false;
        Map<ParameterSymbol, GivenArgument> seen = new HashMap<>();
        for (GivenArgument argument : arguments) {
            if (argument.isLost()) {
                reportUnknown(component, argument.node().name().orElseThrow(), findings);
            } else if (named && argument.node().name().isEmpty()) {
                findings.report(
                        argument.node(),
                        "behind an argument with a name the place of one without tells nothing;"
                                + " write its name, or put it first");
            } else {
                argument.parameter()
                        .ifPresent(parameter -> once(argument, parameter, seen, findings));
            }
            named |= argument.node().name().isPresent();
        }
    }

    private static void reportUnknown(Signature component, Name name, Findings findings) {
        findings.reportUnknown(
                name.span(),
                "component '%s' has no parameter '%s'".formatted(component.name(), name),
                name.text(),
                component.parameters().stream().map(ParameterSymbol::name).toList(),
                "name one that it has");
    }

    private static void once(
            GivenArgument argument,
            ParameterSymbol parameter,
            Map<ParameterSymbol, GivenArgument> seen,
            Findings findings) {
        GivenArgument first = seen.putIfAbsent(parameter, argument);
        if (first != null) {
            findings.report(
                            argument.node(),
                            "parameter '%s' has an argument already; delete one",
                            parameter)
                    .related(first.node(), "the other argument");
        }
    }
}

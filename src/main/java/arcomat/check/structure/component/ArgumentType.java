package arcomat.check.structure.component;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.ConstantFolding;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.TypeRules;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.names.RangeType;
import arcomat.symbols.names.TypeSubstitution;
import arcomat.symbols.names.TypeSymbol;

import java.util.List;

/**
 * ARC0118: arguments and default values are of the type of their parameter. (Hab16 R10, Wor16 MR2)
 */
public final class ArgumentType implements Check.OnComponent, Check.OnInstance {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (ParameterSymbol parameter : component.signature().ownParameters()) {
            if (parameter.initial().isPresent()) {
                check(parameter.initial().get(), parameter, parameter.type(), findings);
            }
        }
        component
                .signature()
                .superComponent()
                .ifPresent(
                        above ->
                                check(
                                        component.signature().superArguments(),
                                        above.substitution(),
                                        findings));
        component.signature().superArguments().forEach(each -> checkRange(each, findings));
    }

    /**
     * An argument stands in the place of the parameter of what is extended, so that nobody would
     * look whether it lies in the range there. Numbers are the business of another law.
     */
    private static void checkRange(GivenArgument argument, Findings findings) {
        Typed value = argument.value();
        if (ConstantFolding.computed(value.expression()).isPresent()) {
            return;
        }
        argument.parameter()
                .filter(each -> each.type() instanceof RangeType)
                .filter(each -> value.isAssignableTo(each.type()))
                .filter(each -> !TypeRules.fits(value.type(), each.type()))
                .ifPresent(
                        parameter ->
                                findings.report(
                                                value.expression().node(),
                                                "parameter '%s' is of type %s, and this value of"
                                                        + " type %s may lie outside; give it a"
                                                        + " range within that",
                                                parameter,
                                                parameter.type().text(),
                                                value.type().text())
                                        .related(parameter.nameSpan(), "the parameter"));
    }

    @Override
    public void check(InstanceSymbol instance, Context context, Findings findings) {
        if (instance.component().isEmpty()) {
            return;
        }
        check(instance.arguments(), instance.type().substitution(), findings);
    }

    private static void check(
            List<GivenArgument> arguments, TypeSubstitution types, Findings findings) {
        for (GivenArgument argument : arguments) {
            argument.parameter()
                    .ifPresent(
                            parameter ->
                                    check(
                                            argument.value(),
                                            parameter,
                                            types.apply(parameter.type()),
                                            findings));
        }
    }

    private static void check(
            Typed value, ParameterSymbol parameter, TypeSymbol expected, Findings findings) {
        if (!value.isAssignableTo(expected)) {
            findings.report(
                            value.expression().node(),
                            "parameter '%s' is of type %s, but this value is of type %s",
                            parameter.name(),
                            Wording.distinct(expected, value.type()),
                            Wording.distinct(value.type(), expected))
                    .related(parameter.nameSpan(), "the parameter");
        }
    }
}

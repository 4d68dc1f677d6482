package arcomat.check.structure.component;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.Typed;
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
    }

    @Override
    public void check(InstanceSymbol instance, Context context, Findings findings) {
        if (instance.component().isEmpty()) {
            return;
        }
        List<ParameterSymbol> parameters = instance.component().get().parameters();
        List<Typed> arguments = instance.arguments();
        for (int i = 0; i < Math.min(arguments.size(), parameters.size()); i++) {
            ParameterSymbol parameter = parameters.get(i);
            TypeSymbol expected = instance.type().substitution().apply(parameter.type());
            check(arguments.get(i), parameter, expected, findings);
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

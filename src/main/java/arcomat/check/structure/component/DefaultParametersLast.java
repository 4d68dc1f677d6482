package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Component.Parameter;

/**
 * ARC0119: parameters with a default value stand behind those without, because arguments are
 * matched from the left. (Wor16 MR)
 */
public final class DefaultParametersLast implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Parameter withDefault = null;
        for (Parameter parameter : component.node().parameters()) {
            if (parameter.initial().isPresent()) {
                withDefault = withDefault == null ? parameter : withDefault;
            } else if (withDefault != null) {
                findings.report(
                                parameter.name(),
                                "parameter '%s' has no default value but '%s' before it has; move"
                                        + " it to the front or give it one",
                                parameter.name(),
                                withDefault.name())
                        .related(withDefault, "has a default value");
            }
        }
    }
}

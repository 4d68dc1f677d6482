package arcomat.check.structure.component;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.tree.Element;

import java.util.List;

/**
 * ARC0117: a part has an argument for each parameter without a default, and none too many. (Hab16
 * R10, Wor16 MR1)
 */
public final class ArgumentCount implements Check.OnInstance {

    @Override
    public void check(InstanceSymbol instance, Context context, Findings findings) {
        if (instance.component().isEmpty()) {
            return;
        }
        ComponentSymbol component = instance.component().get();
        List<ParameterSymbol> parameters = component.parameters();
        int given = instance.arguments().size();
        if (given > parameters.size()) {
            reportSuperfluous(instance, component, findings);
            return;
        }
        List<String> missing = missing(parameters, given);
        if (!missing.isEmpty()) {
            findings.report(
                            place(instance),
                            "component '%s' needs %s for %s; write %s in parentheses behind '%s'",
                            component.name(),
                            missing.size() == 1 ? "an argument" : "arguments",
                            Wording.quoted(missing),
                            missing.size() == 1 ? "it" : "them",
                            component.name())
                    .related(component.nameSpan(), "declared here");
        }
    }

    /** The parameters without an argument that have no default either. */
    public static List<String> missing(List<ParameterSymbol> parameters, int given) {
        return parameters.stream()
                .skip(given)
                .filter(parameter -> parameter.node().initial().isEmpty())
                .map(ParameterSymbol::name)
                .toList();
    }

    private static void reportSuperfluous(
            InstanceSymbol instance, ComponentSymbol component, Findings findings) {
        int expected = component.parameters().size();
        String takes =
                expected == 0
                        ? "no arguments"
                        : (expected == 1 ? "" : "at most ") + Wording.count(expected, "argument");
        findings.report(
                        instance.arguments().get(expected).expression().node(),
                        "component '%s' takes %s, but gets %s; delete what is too much",
                        component.name(),
                        takes,
                        instance.arguments().size())
                .related(component.nameSpan(), "declared here");
    }

    private static Span place(InstanceSymbol instance) {
        return instance.node() instanceof Element.Subcomponent node
                ? node.type().name().span()
                : instance.nameSpan();
    }
}

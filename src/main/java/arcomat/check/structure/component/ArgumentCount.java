package arcomat.check.structure.component;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Element;

import java.util.List;

/**
 * ARC0117: a part has an argument for each parameter without a default, and none too many. (Hab16
 * R10, Wor16 MR1)
 */
public final class ArgumentCount implements Check.OnInstance, Check.OnComponent {

    @Override
    public void check(InstanceSymbol instance, Context context, Findings findings) {
        if (instance.component().isEmpty()) {
            return;
        }
        ComponentSymbol component = instance.component().get();
        check(component.signature(), instance.arguments(), place(instance), findings);
    }

    /** Of the component that it extends, where it gives arguments to that. */
    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Signature heir = component.signature();
        if (heir.node().superArguments().isPresent()) {
            Span place = heir.node().superComponent().orElseThrow().name().span();
            heir.superComponent()
                    .flatMap(ComponentReference::component)
                    .ifPresent(above -> check(above, heir.superArguments(), place, findings));
        }
    }

    private static void check(
            Signature component, List<GivenArgument> given, Span place, Findings findings) {
        if (given.size() > component.parameters().size()) {
            reportSuperfluous(component, given, findings);
            return;
        }
        List<String> missing = missing(component.parameters(), given);
        if (!missing.isEmpty()) {
            findings.report(
                            place,
                            "component '%s' needs %s for %s; write %s in parentheses behind '%s'",
                            component.name(),
                            missing.size() == 1 ? "an argument" : "arguments",
                            Wording.quoted(missing),
                            missing.size() == 1 ? "it" : "them",
                            component.name())
                    .related(component.nameSpan(), "declared here");
        }
    }

    /**
     * The parameters without an argument that have no default either; none where the name of an
     * argument is that of no parameter, which may be misspelt.
     */
    public static List<String> missing(
            List<ParameterSymbol> parameters, List<GivenArgument> given) {
        if (given.stream().anyMatch(GivenArgument::isLost)) {
            return List.of();
        }
        return parameters.stream()
                .filter(parameter -> GivenArgument.find(given, parameter).isEmpty())
                .filter(parameter -> parameter.node().initial().isEmpty())
                .map(ParameterSymbol::name)
                .toList();
    }

    private static void reportSuperfluous(
            Signature component, List<GivenArgument> given, Findings findings) {
        int expected = component.parameters().size();
        String takes =
                expected == 0
                        ? "no arguments"
                        : (expected == 1 ? "" : "at most ") + Wording.count(expected, "argument");
        findings.report(
                        given.get(expected).node(),
                        "component '%s' takes %s, but gets %s; delete what is too much",
                        component.name(),
                        takes,
                        given.size())
                .related(component.nameSpan(), "declared here");
    }

    private static Span place(InstanceSymbol instance) {
        return instance.node() instanceof Element.Subcomponent node
                ? node.type().name().span()
                : instance.nameSpan();
    }
}

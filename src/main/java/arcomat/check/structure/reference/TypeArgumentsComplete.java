package arcomat.check.structure.reference;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.TypeArgument;

import java.util.List;

/** ARC0115: a generic component gets one type for each of its type parameters. (Hab16 R9) */
public final class TypeArgumentsComplete implements Check.OnComponent, Check.OnInstance {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        if (component.signature().superComponent().isPresent()) {
            var written = component.node().superComponent().orElseThrow();
            check(
                    component.signature().superComponent().get(),
                    written.name().span(),
                    written.arguments(),
                    findings);
        }
    }

    @Override
    public void check(InstanceSymbol instance, Context context, Findings findings) {
        if (instance.node() instanceof Element.Subcomponent node) {
            var written = node.type();
            check(instance.type(), written.name().span(), written.arguments(), findings);
        } else if (instance.node() instanceof Component node && node.instance().isPresent()) {
            check(
                    instance.type(),
                    instance.nameSpan(),
                    node.instance().get().arguments(),
                    findings);
        }
    }

    private static void check(
            ComponentReference reference,
            Span place,
            List<TypeArgument> written,
            Findings findings) {
        if (reference.component().isEmpty()) {
            return;
        }
        int expected = reference.component().get().typeParameters().size();
        if (written.size() != expected) {
            findings.report(place, message(reference, expected, written.size()))
                    .related(reference.component().get().nameSpan(), "declared here");
            return;
        }
        for (TypeArgument argument : written) {
            if (argument instanceof TypeArgument.Wildcard) {
                findings.report(
                        argument,
                        "a wildcard is no type; write the type of the messages of '%s'",
                        reference.name());
            }
        }
    }

    private static String message(ComponentReference reference, int expected, int given) {
        return expected == 0
                ? "component '%s' takes no type arguments; delete them".formatted(reference.name())
                : "component '%s' takes %s, but gets %s; write one type for each type parameter"
                        .formatted(
                                reference.name(), Wording.count(expected, "type argument"), given);
    }
}

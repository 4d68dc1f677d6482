package arcomat.check.structure.reference;

import arcomat.check.facts.VisibleNames;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.naming.JavaClassUnique;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Element;
import arcomat.tree.TypeReference;

import java.util.List;

/**
 * ARC0111: a component that is used or extended exists, and it is clear which one is meant. (Hab16
 * R3, R4)
 */
public final class ComponentExists implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        if (component.signature().superComponent().isPresent()) {
            TypeReference written = component.node().superComponent().orElseThrow();
            check(
                    component.signature().superComponent().get(),
                    written,
                    component,
                    context,
                    findings);
        }
        Element.Subcomponent last = null;
        for (InstanceSymbol instance : component.ownInstances()) {
            if (instance.node() instanceof Element.Subcomponent node && node != last) {
                check(instance.type(), node.type(), component, context, findings);
                last = node;
            }
        }
    }

    private static void check(
            ComponentReference reference,
            TypeReference written,
            ComponentSymbol place,
            Context context,
            Findings findings) {
        Span span = written.name().span();
        Resolution<Signature> resolution = reference.resolution();
        if (resolution.isAmbiguous()) {
            if (areDuplicates(resolution.candidates())) {
                return;
            }
            findings.report(
                    span,
                    "'%s' could mean several components; write the full name of one",
                    reference.name());
            for (Signature candidate : resolution.candidates()) {
                findings.related(candidate.nameSpan(), candidate.qualifiedName());
            }
        } else if (resolution.isUnknown()) {
            reportUnknown(reference.name(), written, span, place, context, findings);
        }
    }

    /** Definitions of one full name are the business of {@link JavaClassUnique}. */
    private static boolean areDuplicates(List<Signature> candidates) {
        for (Signature candidate : candidates) {
            if (!candidate.qualifiedName().equals(candidates.get(0).qualifiedName())) {
                return false;
            }
        }
        return true;
    }

    private static void reportUnknown(
            String name,
            TypeReference written,
            Span span,
            ComponentSymbol place,
            Context context,
            Findings findings) {
        if (context.scope().type(written.name()).isFound()) {
            findings.report(span, "'%s' is a type of messages; a part needs a component", name);
            return;
        }
        List<String> elsewhere = VisibleNames.componentsElsewhere(written.name(), context);
        if (elsewhere.size() == 1) {
            Imports.reportMissing(
                    written.name(), "component", elsewhere.get(0), context.unit(), findings);
            return;
        }
        findings.reportUnknown(
                span,
                "there is no component '" + name + "'",
                name,
                VisibleNames.components(place, context),
                "declare or import it");
    }
}

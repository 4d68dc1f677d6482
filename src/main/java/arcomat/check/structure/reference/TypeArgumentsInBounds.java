package arcomat.check.structure.reference;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.TypeRules;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.TypeVariable;
import arcomat.symbols.names.UnknownType;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.TypeArgument;
import arcomat.tree.TypeReference;

import java.util.List;

/** ARC0116: a type argument is within the bounds of its type parameter. (Hab16 R9) */
public final class TypeArgumentsInBounds implements Check.OnComponent, Check.OnInstance {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        if (component.signature().superComponent().isPresent()) {
            check(
                    component.signature().superComponent().get(),
                    component.node().superComponent().orElseThrow().arguments(),
                    component,
                    findings);
        }
    }

    @Override
    public void check(InstanceSymbol instance, Context context, Findings findings) {
        if (instance.node() instanceof Element.Subcomponent node) {
            check(instance.type(), node.type().arguments(), instance.owner(), findings);
        } else if (instance.node() instanceof Component node && node.instance().isPresent()) {
            List<TypeArgument> arguments = node.instance().get().arguments();
            check(instance.type(), arguments, instance.owner(), findings);
        }
    }

    private static void check(
            ComponentReference reference,
            List<TypeArgument> written,
            ComponentSymbol place,
            Findings findings) {
        if (reference.component().isEmpty()) {
            return;
        }
        Signature generic = reference.component().get();
        List<TypeSymbol> types = reference.argumentTypes();
        for (int i = 0; i < Math.min(types.size(), generic.typeParameters().size()); i++) {
            TypeVariable parameter = generic.typeParameters().get(i);
            for (TypeReference bound : parameter.node().bounds()) {
                TypeSymbol limit = boundType(bound, generic, reference);
                if (!isWithin(types.get(i), limit, place)) {
                    report(written.get(i).span(), types.get(i), parameter, limit, findings);
                }
            }
        }
    }

    /** The bound as the user of the component sees it: it may name other type parameters. */
    private static TypeSymbol boundType(
            TypeReference bound, Signature generic, ComponentReference reference) {
        return generic.resolveType(bound)
                .found()
                .map(reference.substitution()::apply)
                .orElse(UnknownType.UNKNOWN);
    }

    private static void report(
            Span span,
            TypeSymbol type,
            TypeVariable parameter,
            TypeSymbol limit,
            Findings findings) {
        findings.report(
                        span,
                        "type argument '%s' is outside the bound of '%s extends %s'; use a type"
                            + " that fits it",
                        type.text(),
                        parameter.text(),
                        limit.text())
                .related(parameter.node(), "the bound");
    }

    private static boolean isWithin(TypeSymbol type, TypeSymbol limit, ComponentSymbol place) {
        if (TypeRules.fits(type, limit)) {
            return true;
        }
        if (type instanceof ClassSymbol symbol) {
            return limit instanceof ClassSymbol && symbol.lineage().contains(limit);
        }
        if (type instanceof TypeVariable variable) {
            for (TypeReference bound : variable.node().bounds()) {
                var own = place.resolveType(bound).found();
                if (own.isEmpty() || isWithin(own.get(), limit, place)) {
                    return true;
                }
            }
        }
        return false;
    }
}

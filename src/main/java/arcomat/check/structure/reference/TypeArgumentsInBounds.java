package arcomat.check.structure.reference;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.TypeRules;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.JavaType;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.TypeVariable;
import arcomat.symbols.names.UnknownType;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.TypeReference;

import java.util.List;

/** ARC0116: a type argument is within the bounds of its type parameter. (Hab16 R9) */
public final class TypeArgumentsInBounds implements Check.OnComponentUse {

    @Override
    public void check(ComponentUse use, Context context, Findings findings) {
        use.reference().component().ifPresent(c -> check(use, c, context, findings));
    }

    private static void check(
            ComponentUse use, Signature generic, Context context, Findings findings) {
        ComponentSymbol place = context.component().orElseThrow();
        List<TypeSymbol> types = use.reference().argumentTypes();
        for (int i = 0; i < Math.min(types.size(), generic.typeParameters().size()); i++) {
            TypeVariable parameter = generic.typeParameters().get(i);
            for (TypeReference bound : parameter.node().bounds()) {
                TypeSymbol limit = boundType(bound, generic, use.reference());
                if (!isWithin(types.get(i), limit, place)) {
                    findings.report(
                                    use.arguments().get(i),
                                    "type argument '%s' is outside the bound of '%s extends %s';"
                                            + " use a type that fits it",
                                    types.get(i).text(),
                                    parameter.text(),
                                    limit.text())
                            .related(parameter.node(), "the bound");
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

    private static boolean isWithin(TypeSymbol type, TypeSymbol limit, ComponentSymbol place) {
        if (TypeRules.fits(type, limit)) {
            return true;
        }
        if (type instanceof TypeVariable variable) {
            for (TypeReference bound : variable.node().bounds()) {
                var own = place.resolveType(bound).found();
                if (own.isEmpty() || isWithin(own.get(), limit, place)) {
                    return true;
                }
            }
            return false;
        }
        return isBelow(type, limit);
    }

    private static boolean isBelow(TypeSymbol type, TypeSymbol limit) {
        if (limit instanceof JavaType java) {
            return isBelow(type, java);
        }
        return type instanceof ClassSymbol symbol
                && limit instanceof ClassSymbol
                && symbol.lineage().contains(limit);
    }

    /** Of built-in types it is known what Java has above them. */
    private static boolean isBelow(TypeSymbol type, JavaType limit) {
        return !(type.base() instanceof BuiltinType builtin) || limit.isAbove(builtin);
    }
}

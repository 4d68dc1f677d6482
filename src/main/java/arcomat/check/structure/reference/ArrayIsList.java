package arcomat.check.structure.reference;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.JavaType;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.TypeReference;

/** ARC0149: a message that holds several values is a list, and is called one. */
public final class ArrayIsList implements Check.OnType {
    @Override
    public void check(TypeReference type, Context context, Findings findings) {
        if (type.dimensions() == 0) {
            return;
        }
        context.resolve(type)
                .found()
                .filter(found -> found instanceof JavaType && !found.isErroneous())
                .map(found -> list(type.dimensions(), found, type))
                .ifPresent(list -> report(type, list, findings));
    }

    private static void report(TypeReference type, String list, Findings findings) {
        findings.report(
                        type,
                        "'%s' is read as '%s': arrays are lists here; write that",
                        type.span().text(),
                        list)
                .fix(Fix.replace("Write '" + list + "'", type.span(), list));
    }

    /** Whatever is in sight of the file, the full name of the list is right. */
    private static String list(int dimensions, TypeSymbol found, TypeReference type) {
        if (dimensions == 0) {
            return element(found, type);
        }
        JavaType java = (JavaType) found;
        TypeSymbol held = java.arguments().get(0).type();
        return java.qualifiedName() + "<" + list(dimensions - 1, held, type) + ">";
    }

    /** As it is written, or the box of a primitive. */
    private static String element(TypeSymbol element, TypeReference type) {
        if (element instanceof BuiltinType builtin) {
            return builtin.objectName();
        }
        String written = type.span().text();
        return type.arguments().isEmpty()
                ? type.name().text()
                : written.substring(0, written.lastIndexOf('>') + 1);
    }
}

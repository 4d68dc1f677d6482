package arcomat.check.structure.reference;

import arcomat.check.law.Check;
import arcomat.symbols.names.JavaType;
import arcomat.tree.TypeReference;

/** ARC0147: types of {@code java.util} are imported, though the older tools did without. */
public final class JavaTypeImported implements Check.OnType {

    @Override
    public void check(TypeReference type, Context context, Findings findings) {
        context.scope()
                .missingImport(type.name())
                .filter(full -> isMeant(full, type, context))
                .ifPresent(
                        full ->
                                Imports.reportMissing(
                                        type.name(), "type", full, context.unit(), findings));
    }

    /** And no type parameter of that name. */
    private static boolean isMeant(String full, TypeReference type, Context context) {
        return context.resolve(type).found().orElse(null) instanceof JavaType java
                && java.qualifiedName().equals(full);
    }
}

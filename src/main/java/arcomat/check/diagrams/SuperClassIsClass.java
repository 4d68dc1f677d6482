package arcomat.check.diagrams;

import arcomat.check.law.Check;
import arcomat.symbols.names.ClassSymbol;
import arcomat.tree.TypeReference;

/** ARC0606: what a class extends is a class, neither an enum nor a built-in type. */
public final class SuperClassIsClass implements Check.OnClass {

    @Override
    public void check(ClassSymbol symbol, Context context, Findings findings) {
        symbol.node().superClass().ifPresent(above -> check(symbol, above, context, findings));
    }

    private static void check(
            ClassSymbol symbol, TypeReference above, Context context, Findings findings) {
        context.resolve(above)
                .found()
                .filter(type -> !(type instanceof ClassSymbol) && !type.isErroneous())
                .ifPresent(
                        type ->
                                findings.report(
                                        above,
                                        "class '%s' cannot extend '%s', which is no class; make it"
                                                + " an attribute",
                                        symbol.text(),
                                        type.text()));
    }
}

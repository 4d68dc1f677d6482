package arcomat.check.structure.reference;

import arcomat.check.facts.VisibleNames;
import arcomat.check.law.Check;
import arcomat.symbols.names.Names;
import arcomat.tree.Unit;
import arcomat.tree.Unit.Import;

/**
 * ARC0121: an import leads to something that exists. Imports from the Java library stay unreported:
 * what they are for is reported where it is used.
 */
public final class ImportResolves implements Check.OnUnit {

    @Override
    public void check(Unit unit, Context context, Findings findings) {
        for (Import each : unit.imports()) {
            boolean unknown = context.scope().target(each).isUnknown();
            if (unknown && !isJava(each.name().text())) {
                report(each, context, findings);
            }
        }
    }

    private static boolean isJava(String name) {
        return name.startsWith("java.") || name.startsWith("javax.");
    }

    private static void report(Import each, Context context, Findings findings) {
        String name = each.name().text();
        String kinds =
                each.wildcard()
                        ? "there is no package, class diagram or component '"
                        : "there is no component or type '";
        findings.reportUnknown(
                each.name().span(),
                kinds + name + "'",
                name,
                VisibleNames.qualified(context.workspace()),
                advice(each));
    }

    /** Nobody knows whether a class of Java was meant, but its package can say what it is. */
    private static String advice(Import each) {
        String simple = each.name().last().text();
        boolean mayBeClass =
                !each.wildcard()
                        && !each.name().isSimple()
                        && Character.isUpperCase(simple.charAt(0));
        return mayBeClass
                ? "correct or delete the import, or write 'type "
                        + simple
                        + ";' in a class diagram of package '"
                        + Names.qualifier(each.name().text())
                        + "' if it is a class of Java"
                : "correct or delete the import";
    }
}

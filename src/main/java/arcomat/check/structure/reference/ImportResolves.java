package arcomat.check.structure.reference;

import arcomat.check.facts.VisibleNames;
import arcomat.check.law.Check;
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
                "correct or delete the import");
    }
}

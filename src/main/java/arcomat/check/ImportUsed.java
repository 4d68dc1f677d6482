package arcomat.check;

import arcomat.tree.Import;
import arcomat.tree.QualifiedName;
import arcomat.tree.Unit;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** ARC0123: something in the file needs the import. (Hab16 CV4) */
final class ImportUsed implements Check.OnNames {

    @Override
    public Law law() {
        return Law.warning("ARC0123");
    }

    @Override
    public void check(Unit unit, List<QualifiedName> names, Context context, Findings findings) {
        Set<String> used = new HashSet<>();
        for (QualifiedName name : names) {
            context.scope().importOf(name).ifPresent(each -> used.add(text(each)));
        }
        boolean somethingIsAmbiguous = isAmbiguous(names, context);
        for (Import each : unit.imports()) {
            boolean leadsSomewhere = context.scope().target(each).isFound();
            if (leadsSomewhere && !somethingIsAmbiguous && !used.contains(text(each))) {
                findings.report(
                                each,
                                "nothing in this file needs '"
                                        + text(each)
                                        + "'; delete the import")
                        .fix(Deletion.ofLine("Delete the import", each));
            }
        }
    }

    /** Then several imports explain one name, which is another finding. */
    private static boolean isAmbiguous(List<QualifiedName> names, Context context) {
        for (QualifiedName name : names) {
            if (context.scope().type(name).isAmbiguous()
                    || context.scope().component(name).isAmbiguous()) {
                return true;
            }
        }
        return false;
    }

    private static String text(Import each) {
        return each.name().text() + (each.wildcard() ? ".*" : "");
    }
}

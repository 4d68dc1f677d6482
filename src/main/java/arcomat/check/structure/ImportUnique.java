package arcomat.check.structure;

import arcomat.check.facts.Deletion;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.tree.Import;
import arcomat.tree.Unit;

import java.util.HashMap;
import java.util.Map;

/** ARC0122: nothing is imported twice. (Hab16 CV3) */
public final class ImportUnique implements Check.OnUnit {

    @Override
    public Law law() {
        return Law.warning("ARC0122");
    }

    @Override
    public void check(Unit unit, Context context, Findings findings) {
        Map<String, Import> seen = new HashMap<>();
        for (Import each : unit.imports()) {
            String text = each.name().text() + (each.wildcard() ? ".*" : "");
            Import first = seen.putIfAbsent(text, each);
            if (first != null) {
                findings.report(each, "'" + text + "' is imported twice; delete this import")
                        .related(first, "the first import")
                        .fix(Deletion.ofLine("Delete the import", each));
            }
        }
    }
}

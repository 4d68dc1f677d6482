package arcomat.check.structure.reference;

import arcomat.check.facts.Deletion;
import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.tree.Unit;

/** ARC0122: nothing is imported twice. (Hab16 CV3) */
public final class ImportUnique implements Check.OnUnit {

    @Override
    public void check(Unit unit, Context context, Findings findings) {
        Duplicates.report(
                unit.imports(),
                ImportUsed::text,
                (each, first) ->
                        findings.report(
                                        each,
                                        "'%s' is imported twice; delete this import",
                                        ImportUsed.text(each))
                                .related(first, "the first import")
                                .fix(Deletion.ofLine("Delete the import", each)));
    }
}

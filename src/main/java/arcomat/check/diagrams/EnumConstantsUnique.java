package arcomat.check.diagrams;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.tree.ClassDiagram;

/** ARC0602: the constants of an enum differ in name. */
public final class EnumConstantsUnique implements Check.OnEnum {

    @Override
    public void check(ClassDiagram.EnumDefinition definition, Context context, Findings findings) {
        Duplicates.report(
                definition.constants(),
                findings,
                "enum '%s' lists '%s' twice; rename or remove one",
                definition.name(),
                "first listed here");
    }
}

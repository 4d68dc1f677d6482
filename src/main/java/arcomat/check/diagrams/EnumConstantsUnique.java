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
                (constant, first) ->
                        findings.report(
                                        constant,
                                        "enum '%s' lists '%s' twice; rename or remove one",
                                        definition.name(),
                                        constant)
                                .related(first, "first listed here"));
    }
}

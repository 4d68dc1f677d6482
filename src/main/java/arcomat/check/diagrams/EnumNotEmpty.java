package arcomat.check.diagrams;

import arcomat.check.law.Check;
import arcomat.tree.ClassDiagram;

/** ARC0605: an enum has at least one constant. */
public final class EnumNotEmpty implements Check.OnEnum {

    @Override
    public void check(ClassDiagram.EnumDefinition definition, Context context, Findings findings) {
        if (definition.constants().isEmpty()) {
            findings.report(
                    definition.name(),
                    "enum '%s' has no constants, so a port of this type could never carry a"
                            + " message; list its constants",
                    definition.name());
        }
    }
}

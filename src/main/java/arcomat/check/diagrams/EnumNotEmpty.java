package arcomat.check.diagrams;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.tree.ClassDiagram;

/** ARC0605: an enum has at least one constant. */
public final class EnumNotEmpty implements Check.OnClassDiagram {

    @Override
    public Law law() {
        return Law.error("ARC0605").needing(Law.Needs.ALL);
    }

    @Override
    public void check(DiagramSymbol diagram, Context context, Findings findings) {
        for (ClassDiagram.TypeDefinition type : diagram.node().types()) {
            if (type instanceof ClassDiagram.EnumDefinition definition
                    && definition.constants().isEmpty()) {
                findings.report(
                        definition.name(),
                        "enum '"
                                + definition.name()
                                + "' has no constants, so a port of this type could never carry"
                                + " a message; list its constants");
            }
        }
    }
}

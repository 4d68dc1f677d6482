package arcomat.check;

import arcomat.symbols.DiagramSymbol;
import arcomat.tree.ClassDiagram;

/** ARC0605: an enum has at least one constant. */
final class EnumNotEmpty implements Check.OnClassDiagram {

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

package arcomat.check.diagrams;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.tree.ClassDiagram;

/** ARC0608: an enum is small enough to become a Java class. */
public final class EnumFitsClass implements Check.OnClassDiagram {
    /** A class is set up by one method of 64 kB, and a constant takes 24 bytes of it. */
    private static final int MOST = 2_700;

    @Override
    public Law law() {
        return Law.warningThenError("ARC0608");
    }

    @Override
    public void check(DiagramSymbol diagram, Context context, Findings findings) {
        for (ClassDiagram.TypeDefinition type : diagram.node().types()) {
            if (type instanceof ClassDiagram.EnumDefinition definition
                    && definition.constants().size() > MOST) {
                findings.report(
                        definition.name(),
                        "enum '"
                                + definition.name()
                                + "' has "
                                + definition.constants().size()
                                + " constants, and a Java class has room for "
                                + MOST
                                + ", so no code can be generated; use a range of numbers, such as"
                                + " Integer[1.."
                                + definition.constants().size()
                                + "]");
            }
        }
    }
}

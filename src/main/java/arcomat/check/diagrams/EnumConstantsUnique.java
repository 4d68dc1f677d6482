package arcomat.check.diagrams;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.tree.ClassDiagram;
import arcomat.tree.Name;

import java.util.HashMap;
import java.util.Map;

/** ARC0602: the constants of an enum differ in name. */
public final class EnumConstantsUnique implements Check.OnClassDiagram {

    @Override
    public Law law() {
        return Law.error("ARC0602");
    }

    @Override
    public void check(DiagramSymbol diagram, Context context, Findings findings) {
        for (ClassDiagram.TypeDefinition type : diagram.node().types()) {
            if (type instanceof ClassDiagram.EnumDefinition definition) {
                check(definition, findings);
            }
        }
    }

    private static void check(ClassDiagram.EnumDefinition definition, Findings findings) {
        Map<String, Name> seen = new HashMap<>();
        for (Name constant : definition.constants()) {
            Name first = seen.putIfAbsent(constant.text(), constant);
            if (first != null) {
                findings.report(
                                constant,
                                "enum '"
                                        + definition.name()
                                        + "' lists '"
                                        + constant
                                        + "' twice; rename or remove one")
                        .related(first, "first listed here");
            }
        }
    }
}

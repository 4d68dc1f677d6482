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

/** ARC0601: the types of one class diagram differ in name. */
public final class DiagramTypesUnique implements Check.OnClassDiagram {

    @Override
    public Law law() {
        return Law.error("ARC0601");
    }

    @Override
    public void check(DiagramSymbol diagram, Context context, Findings findings) {
        Map<String, Name> seen = new HashMap<>();
        for (ClassDiagram.TypeDefinition type : diagram.node().types()) {
            Name first = seen.putIfAbsent(type.name().text(), type.name());
            if (first != null) {
                findings.report(
                                type.name(),
                                "class diagram '"
                                        + diagram.node().name()
                                        + "' defines '"
                                        + type.name()
                                        + "' twice; rename or remove one")
                        .related(first, "first defined here");
            }
        }
    }
}

package arcomat.check.diagrams;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.tree.ClassDiagram;

/** ARC0601: the types of one class diagram differ in name. */
public final class DiagramTypesUnique implements Check.OnClassDiagram {

    @Override
    public void check(DiagramSymbol diagram, Context context, Findings findings) {
        Duplicates.report(
                diagram.node().types().stream().map(ClassDiagram.TypeDefinition::name).toList(),
                findings,
                "class diagram '%s' defines '%s' twice; rename or remove one",
                diagram.node().name(),
                "first defined here");
    }
}

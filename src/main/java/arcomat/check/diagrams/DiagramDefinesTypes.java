package arcomat.check.diagrams;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.tree.ClassDiagram;

import java.util.List;

/**
 * ARC0609: a class diagram defines types of messages; what else the older tools read in it means
 * nothing here. One finding for each type and each association that says more.
 */
public final class DiagramDefinesTypes implements Check.OnClassDiagram {
    private static final int MOST_NAMED = 4;

    @Override
    public void check(DiagramSymbol diagram, Context context, Findings findings) {
        diagram.node().types().forEach(each -> check(each, findings));
        diagram.node().associations().forEach(each -> check(each, findings));
    }

    private static void check(ClassDiagram.TypeDefinition type, Findings findings) {
        List<Ornament> ornaments = Ornament.of(type);
        if (ornaments.isEmpty()) {
            return;
        }
        List<String> named = ornaments.stream().map(Ornament::words).distinct().toList();
        findings.report(
                ornaments.get(0).place(),
                "%s '%s' says more than a type of messages can mean: %s; delete it, or suppress"
                        + " this finding if another tool needs it",
                kind(type),
                type.name(),
                Wording.firstOf(named, MOST_NAMED));
    }

    private static String kind(ClassDiagram.TypeDefinition type) {
        if (type instanceof ClassDiagram.EnumDefinition) {
            return "enum";
        }
        return type instanceof ClassDiagram.ClassDefinition ? "class" : "interface";
    }

    private static void check(ClassDiagram.Association association, Findings findings) {
        findings.report(
                association,
                "%s means nothing here, as objects hold nothing but their attributes; write an"
                        + " attribute for what '%s' holds, or suppress this finding if another tool"
                        + " needs it",
                association
                        .name()
                        .map(name -> association.kind() + " '" + name + "'")
                        .orElse("this " + association.kind()),
                association.left().type().span().text());
    }
}

package arcomat.check.diagrams;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.DiagramSymbol;

import java.util.HashMap;
import java.util.Map;

/** ARC0603: the attributes of a class, inherited ones included, differ in name. */
public final class AttributesUnique implements Check.OnClassDiagram {

    @Override
    public Law law() {
        return Law.error("ARC0603");
    }

    @Override
    public void check(DiagramSymbol diagram, Context context, Findings findings) {
        for (DefinedType type : diagram.types()) {
            if (type instanceof ClassSymbol symbol) {
                check(symbol, findings);
            }
        }
    }

    /** Among inherited attributes the finding belongs to the class that declares the second one. */
    private static void check(ClassSymbol symbol, Findings findings) {
        Map<String, ClassSymbol.AttributeSymbol> seen = new HashMap<>();
        for (ClassSymbol.AttributeSymbol attribute : symbol.attributes()) {
            ClassSymbol.AttributeSymbol first = seen.putIfAbsent(attribute.name(), attribute);
            if (first != null && attribute.owner().equals(symbol)) {
                report(symbol, attribute, first, findings);
            }
        }
    }

    private static void report(
            ClassSymbol symbol,
            ClassSymbol.AttributeSymbol attribute,
            ClassSymbol.AttributeSymbol first,
            Findings findings) {
        String where =
                first.owner().equals(symbol)
                        ? ""
                        : ", inherited from '" + first.owner().text() + "'";
        findings.report(
                        attribute.node().name(),
                        "class '"
                                + symbol.text()
                                + "' has an attribute '"
                                + attribute.name()
                                + "' already"
                                + where
                                + "; rename or remove one")
                .related(first.node().name(), "the other attribute");
    }
}

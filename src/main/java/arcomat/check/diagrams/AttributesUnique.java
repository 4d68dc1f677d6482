package arcomat.check.diagrams;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.ClassSymbol.AttributeSymbol;

/** ARC0603: the attributes of a class, inherited ones included, differ in name. */
public final class AttributesUnique implements Check.OnClass {

    /** Among inherited attributes the finding belongs to the class that declares the second one. */
    @Override
    public void check(ClassSymbol symbol, Context context, Findings findings) {
        Duplicates.report(
                symbol.attributes(),
                AttributeSymbol::name,
                (attribute, first) -> {
                    if (attribute.owner().equals(symbol)) {
                        report(symbol, attribute, first, findings);
                    }
                });
    }

    private static void report(
            ClassSymbol symbol,
            AttributeSymbol attribute,
            AttributeSymbol first,
            Findings findings) {
        String where =
                first.owner().equals(symbol)
                        ? ""
                        : ", inherited from '" + first.owner().text() + "'";
        findings.report(
                        attribute.node().name(),
                        "class '%s' has an attribute '%s' already%s; rename or remove one",
                        symbol.text(),
                        attribute.name(),
                        where)
                .related(first.node().name(), "the other attribute");
    }
}

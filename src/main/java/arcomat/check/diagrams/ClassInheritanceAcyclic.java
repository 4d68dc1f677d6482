package arcomat.check.diagrams;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.DiagramSymbol;

import java.util.List;
import java.util.stream.Collectors;

/** ARC0604: no class inherits from itself, over any number of steps. */
public final class ClassInheritanceAcyclic implements Check.OnClassDiagram {

    @Override
    public Law law() {
        return Law.error("ARC0604");
    }

    /** A cycle is reported at its first class in the text. */
    @Override
    public void check(DiagramSymbol diagram, Context context, Findings findings) {
        for (DefinedType type : diagram.types()) {
            if (type instanceof ClassSymbol symbol
                    && symbol.isItsOwnAncestor()
                    && isFirst(symbol)) {
                report(symbol, findings);
            }
        }
    }

    private static boolean isFirst(ClassSymbol symbol) {
        return symbol.lineage().stream()
                .allMatch(
                        other ->
                                !other.unit().equals(symbol.unit())
                                        || other.nameSpan().start() >= symbol.nameSpan().start());
    }

    private static void report(ClassSymbol symbol, Findings findings) {
        List<ClassSymbol> cycle = symbol.lineage();
        String names = cycle.stream().map(c -> c.text() + " -> ").collect(Collectors.joining());
        findings.report(
                symbol.node().superClass().orElseThrow(),
                "class '"
                        + symbol.text()
                        + "' inherits from itself ("
                        + names
                        + symbol.text()
                        + "); remove one 'extends'");
        for (ClassSymbol other : cycle.subList(1, cycle.size())) {
            findings.related(other.nameSpan(), "on the cycle");
        }
    }
}

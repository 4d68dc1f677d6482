package arcomat.check.diagrams;

import arcomat.check.law.Check;
import arcomat.symbols.names.ClassSymbol;

import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;

/** ARC0604: no class inherits from itself, over any number of steps. */
public final class ClassInheritanceAcyclic implements Check.OnClass {

    /** A cycle is reported at its first class in the text. */
    @Override
    public void check(ClassSymbol symbol, Context context, Findings findings) {
        if (symbol.isItsOwnAncestor() && isFirst(symbol, symbol.lineage())) {
            report(symbol, findings);
        }
    }

    /** Whether no other class of a cycle stands before it in its file. */
    static boolean isFirst(ClassSymbol symbol, Collection<ClassSymbol> cycle) {
        return cycle.stream()
                .filter(other -> other.unit().equals(symbol.unit()))
                .allMatch(other -> other.nameSpan().start() >= symbol.nameSpan().start());
    }

    private static void report(ClassSymbol symbol, Findings findings) {
        List<ClassSymbol> cycle = symbol.lineage();
        String names = cycle.stream().map(c -> c.text() + " -> ").collect(Collectors.joining());
        findings.report(
                symbol.node().superClass().orElseThrow(),
                "class '%s' inherits from itself (%s%s); remove one 'extends'",
                symbol.text(),
                names,
                symbol.text());
        for (ClassSymbol other : cycle.subList(1, cycle.size())) {
            findings.related(other.nameSpan(), "on the cycle");
        }
    }
}

package arcomat.check.diagrams;

import arcomat.check.law.Check;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.ClassSymbol.AttributeSymbol;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * ARC0607: no object contains one of its own class, over any number of attributes. Messages are
 * values, and such a value would have no end.
 */
public final class ClassContainsItself implements Check.OnClass {
    private record Step(ClassSymbol from, AttributeSymbol attribute) {}

    /** A cycle is reported at its first class in the text. */
    @Override
    public void check(ClassSymbol symbol, Context context, Findings findings) {
        List<AttributeSymbol> cycle = shortestCycle(symbol);
        List<ClassSymbol> classes =
                cycle.stream().flatMap(each -> contained(each).stream()).toList();
        if (!cycle.isEmpty() && ClassInheritanceAcyclic.isFirst(symbol, classes)) {
            report(symbol, cycle, findings);
        }
    }

    /** The attributes that lead from a class back to it; empty if none do. */
    private static List<AttributeSymbol> shortestCycle(ClassSymbol start) {
        Map<ClassSymbol, Step> reachedBy = new HashMap<>();
        Deque<ClassSymbol> open = new ArrayDeque<>(List.of(start));
        while (!open.isEmpty() && !reachedBy.containsKey(start)) {
            ClassSymbol current = open.remove();
            for (AttributeSymbol attribute : current.attributes()) {
                contained(attribute)
                        .filter(
                                next ->
                                        reachedBy.putIfAbsent(next, new Step(current, attribute))
                                                == null)
                        .ifPresent(open::add);
            }
        }
        LinkedList<AttributeSymbol> way = new LinkedList<>();
        Step last = reachedBy.get(start);
        while (last != null) {
            way.addFirst(last.attribute());
            last = last.from().equals(start) ? null : reachedBy.get(last.from());
        }
        return way;
    }

    private static Optional<ClassSymbol> contained(AttributeSymbol attribute) {
        return attribute.type() instanceof ClassSymbol type ? Optional.of(type) : Optional.empty();
    }

    private static void report(ClassSymbol symbol, List<AttributeSymbol> cycle, Findings findings) {
        String names =
                cycle.stream()
                        .map(attribute -> " -> " + attribute.type().text())
                        .collect(Collectors.joining());
        AttributeSymbol first = cycle.get(0);
        findings.report(
                first.node().type(),
                "class '%s' would contain itself without end (%s%s); remove attribute '%s', or send"
                        + " a number that stands for the other object",
                symbol.text(),
                symbol.text(),
                names,
                first.name());
        for (AttributeSymbol other : cycle.subList(1, cycle.size())) {
            findings.related(other.node().name().span(), "on the cycle");
        }
    }
}

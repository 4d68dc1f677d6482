package arcomat.pipeline.check;

import arcomat.source.Diagnostic;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.Set;

/** Components with all that they are made of: their parts, what they extend, and so on. */
record MadeOf(Set<ComponentSymbol> components) {

    static MadeOf those(Collection<ComponentSymbol> roots) {
        Set<ComponentSymbol> reached = new LinkedHashSet<>();
        Deque<ComponentSymbol> open = new ArrayDeque<>(roots);
        while (!open.isEmpty()) {
            ComponentSymbol component = open.remove();
            if (reached.add(component)) {
                open.addAll(component.lineage());
                component.instances().stream()
                        .flatMap((InstanceSymbol part) -> part.component().stream())
                        .forEach(open::add);
            }
        }
        return new MadeOf(reached);
    }

    boolean isEmpty() {
        return components.isEmpty();
    }

    /** Whether a finding is about one of them. */
    boolean contains(Diagnostic finding) {
        return components.stream().anyMatch(c -> c.node().span().isAround(finding.span()));
    }
}

package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** ARC0113: no component extends itself, over any number of steps. (Hab16 R11) */
public final class InheritanceAcyclic implements Check.OnWorkspace {

    @Override
    public void check(Workspace workspace, Findings findings) {
        Set<ComponentSymbol> reported = new HashSet<>();
        for (ComponentSymbol component : workspace.components()) {
            if (component.signature().isItsOwnAncestor() && !reported.contains(component)) {
                List<ComponentSymbol> cycle = component.lineage();
                reported.addAll(cycle);
                report(component, cycle, findings);
            }
        }
    }

    private static void report(
            ComponentSymbol component, List<ComponentSymbol> cycle, Findings findings) {
        String text = cycle.stream().map(c -> c.name() + " -> ").collect(Collectors.joining());
        findings.report(
                component.node().superComponent().orElseThrow(),
                "component '%s' extends itself: %s%s; let one of them extend another component or"
                        + " none",
                component.name(),
                text,
                component.name());
    }
}

package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;

import java.util.List;
import java.util.stream.Collectors;

/** ARC0112: no component is a part of itself, over any number of steps. (Hab16 R13) */
public final class SubcomponentAcyclic implements Check.OnWorkspace {

    @Override
    public void check(Workspace workspace, Findings findings) {
        for (List<ComponentSymbol> cycle : workspace.subcomponentCycles()) {
            ComponentSymbol first = cycle.get(0);
            findings.report(
                    place(first, next(cycle, 0)),
                    "component '%s' is a part of itself: %s; replace one of these parts",
                    first.name(),
                    text(cycle));
            for (int i = 1; i < cycle.size(); i++) {
                findings.related(
                        place(cycle.get(i), next(cycle, i)),
                        "'" + cycle.get(i).name() + "' contains '" + next(cycle, i).name() + "'");
            }
        }
    }

    private static ComponentSymbol next(List<ComponentSymbol> cycle, int index) {
        return cycle.get((index + 1) % cycle.size());
    }

    private static Span place(ComponentSymbol whole, ComponentSymbol part) {
        return whole.instances().stream()
                .filter(instance -> instance.component().filter(part::equals).isPresent())
                .findFirst()
                .orElseThrow()
                .nameSpan();
    }

    private static String text(List<ComponentSymbol> cycle) {
        return cycle.stream()
                .map(ComponentSymbol::name)
                .collect(Collectors.joining(" -> ", "", " -> " + cycle.get(0).name()));
    }
}

package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;

import java.util.Comparator;
import java.util.Locale;
import java.util.Map;

/**
 * ARC0131: a component has no more parts than can be made. Ten lines that name ten parts each are
 * ten thousand million parts.
 */
public final class PartsCountable implements Check.OnWorkspace {
    /**
     * More than a brick or a simulation can hold; so many can be lowered and connected in a moment.
     */
    private static final long MOST = 100_000;

    /** What consists of such components has too many parts as well, and that is no news. */
    @Override
    public void check(Workspace workspace, Findings findings) {
        Map<ComponentSymbol, Long> counts = workspace.partCounts();
        counts.forEach(
                (component, count) -> {
                    if (count > MOST && parts(component, counts) <= MOST) {
                        report(component, count, counts, findings);
                    }
                });
    }

    /** The most that one of its parts consists of. */
    private static long parts(ComponentSymbol component, Map<ComponentSymbol, Long> counts) {
        return component.instances().stream()
                .mapToLong(instance -> count(instance, counts))
                .max()
                .orElse(0);
    }

    private static long count(InstanceSymbol instance, Map<ComponentSymbol, Long> counts) {
        return instance.component().map(part -> counts.getOrDefault(part, 0L)).orElse(0L);
    }

    private static void report(
            ComponentSymbol component,
            long count,
            Map<ComponentSymbol, Long> counts,
            Findings findings) {
        findings.report(
                component.nameSpan(),
                "component '%s' consists of %,d parts, of which %,d can be made; leave some out",
                component.name(),
                count,
                MOST);
        component.instances().stream()
                .max(Comparator.comparingLong(instance -> count(instance, counts)))
                .filter(most -> count(most, counts) > 0)
                .ifPresent(
                        most ->
                                findings.related(
                                        most.nameSpan(),
                                        String.format(
                                                Locale.ROOT,
                                                "'%s' alone has %,d",
                                                most.name(),
                                                count(most, counts))));
    }
}

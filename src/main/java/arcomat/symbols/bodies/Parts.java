package arcomat.symbols.bodies;

import arcomat.graph.Digraph;
import arcomat.graph.ShortestCycles;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Which components are made of which. */
public final class Parts {
    private record Visit(ComponentSymbol component, Iterator<InstanceSymbol> rest) {}

    /** Nobody needs to know more exactly, and sums of many of them are numbers still. */
    private static final long COUNTLESS = 1_000_000_000_000L;

    private Parts() {}

    /** A component after everything it is made of; components that contain themselves come once. */
    static List<ComponentSymbol> innermostFirst(ComponentSymbol component) {
        return innermostFirst(component, new HashSet<>());
    }

    /**
     * @param seen what has come before and does not come again
     */
    private static List<ComponentSymbol> innermostFirst(
            ComponentSymbol component, Set<ComponentSymbol> seen) {
        List<ComponentSymbol> order = new ArrayList<>();
        if (!seen.add(component)) {
            return order;
        }
        Deque<Visit> path = new ArrayDeque<>();
        path.push(new Visit(component, component.instances().iterator()));
        while (!path.isEmpty()) {
            Visit visit = path.peek();
            if (!visit.rest().hasNext()) {
                order.add(path.pop().component());
                continue;
            }
            visit.rest()
                    .next()
                    .component()
                    .filter(seen::add)
                    .ifPresent(part -> path.push(new Visit(part, part.instances().iterator())));
        }
        return order;
    }

    /**
     * How many instances are in each component, at all levels; at most a number without meaning.
     */
    public static Map<ComponentSymbol, Long> counts(List<ComponentSymbol> components) {
        Map<ComponentSymbol, Long> counts = new HashMap<>();
        Set<ComponentSymbol> seen = new HashSet<>();
        for (ComponentSymbol component : components) {
            for (ComponentSymbol each : innermostFirst(component, seen)) {
                counts.put(each, count(each, counts));
            }
        }
        return counts;
    }

    private static long count(ComponentSymbol component, Map<ComponentSymbol, Long> counts) {
        long count = 0;
        for (InstanceSymbol instance : component.instances()) {
            long inside =
                    instance.component().map(part -> counts.getOrDefault(part, 0L)).orElse(0L);
            count += 1 + inside;
        }
        return Math.min(count, COUNTLESS);
    }

    /** Cycles of components that contain each other. */
    public static List<List<ComponentSymbol>> cycles(List<ComponentSymbol> components) {
        Map<ComponentSymbol, Integer> numbers = new HashMap<>();
        components.forEach(component -> numbers.put(component, numbers.size()));
        Digraph graph = new Digraph(components.size());
        for (int whole = 0; whole < components.size(); whole++) {
            int number = whole;
            Set<ComponentSymbol> parts = new HashSet<>();
            for (InstanceSymbol instance : components.get(whole).instances()) {
                instance.component()
                        .filter(parts::add)
                        .map(numbers::get)
                        .ifPresent(part -> graph.addEdge(number, part));
            }
        }
        return ShortestCycles.of(graph).stream()
                .map(cycle -> cycle.stream().map(components::get).toList())
                .toList();
    }

    /**
     * Whether a component steps once per event or once per slice. A decomposed component is what
     * its parts are: the first atomic one decides. Platform components, and those that only pass
     * messages on, adapt to their surroundings: empty where there are no others inside.
     */
    public static Optional<Boolean> eventDriven(ComponentSymbol component) {
        return eventDriven(component, new HashSet<>());
    }

    private static Optional<Boolean> eventDriven(
            ComponentSymbol component, Set<ComponentSymbol> seen) {
        if (component.isPlatform() || !seen.add(component)) {
            return Optional.empty();
        }
        if (!component.isDecomposed()) {
            return Optional.of(component.signature().timing().eventDriven());
        }
        for (InstanceSymbol instance : component.instances()) {
            Optional<Boolean> found = instance.component().flatMap(c -> eventDriven(c, seen));
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }
}

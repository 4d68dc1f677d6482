package arcomat.symbols;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Which components are made of which. */
final class Parts {
    private record Visit(ComponentSymbol component, Iterator<InstanceSymbol> rest) {}

    private Parts() {}

    /** A component after everything it is made of; components that contain themselves come once. */
    static List<ComponentSymbol> innermostFirst(ComponentSymbol component) {
        List<ComponentSymbol> order = new ArrayList<>();
        Set<ComponentSymbol> seen = new HashSet<>(List.of(component));
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

    /** Cycles of components that contain each other. */
    static List<List<ComponentSymbol>> cycles(List<ComponentSymbol> components) {
        Map<ComponentSymbol, Integer> numbers = new HashMap<>();
        components.forEach(component -> numbers.put(component, numbers.size()));
        Graph graph = new Graph(components.size());
        for (ComponentSymbol component : components) {
            Set<ComponentSymbol> parts = new HashSet<>();
            for (InstanceSymbol instance : component.instances()) {
                instance.component()
                        .filter(parts::add)
                        .ifPresent(p -> graph.addEdge(numbers.get(component), numbers.get(p)));
            }
        }
        return graph.cycles().stream()
                .map(cycle -> cycle.stream().map(components::get).toList())
                .toList();
    }
}

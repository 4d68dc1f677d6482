package arcomat.symbols;

import java.util.List;
import java.util.Optional;

/** Follows names of instances into a component. */
public final class InstancePath {
    private InstancePath() {}

    /**
     * The port that a test of a component reaches under a path: {@code port} of the component
     * itself, or {@code a.b.port} of a platform component inside it, with types seen from the
     * component.
     */
    public static Resolution<PortSymbol> port(ComponentSymbol component, List<String> path) {
        ComponentSymbol current = component;
        TypeSubstitution substitution = TypeSubstitution.NONE;
        for (String name : path.subList(0, path.size() - 1)) {
            Optional<InstanceSymbol> instance = current.instance(name);
            if (instance.isEmpty()) {
                return Resolution.unknown();
            }
            if (instance.get().component().isEmpty()) {
                return Resolution.excused();
            }
            substitution = instance.get().type().substitution().then(substitution);
            current = instance.get().component().get();
        }
        if (path.size() > 1 && !current.isPlatform()) {
            return Resolution.unknown();
        }
        TypeSubstitution seen = substitution;
        return current.port(path.get(path.size() - 1))
                .<Resolution<PortSymbol>>map(p -> new Resolution.Found<>(p.with(seen)))
                .orElseGet(Resolution::unknown);
    }
}

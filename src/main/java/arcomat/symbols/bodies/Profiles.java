package arcomat.symbols.bodies;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;

/**
 * Whether components step once per event or once per slice. A decomposed component is what its
 * parts are; platform components, and those that only pass messages on, adapt to their
 * surroundings.
 */
public final class Profiles {
    private Profiles() {}

    /** Decided by the first atomic component inside; empty where there is none. */
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

package arcomat.check.stereotypes;

import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.signatures.Layer;
import arcomat.tree.Stereotype;

import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Which layer of a robot program a component belongs to (the paper, section 4). */
final class Layers {
    /** An instance and those around it, innermost first. */
    private record Step(InstanceSymbol instance, @Nullable Step around) {}

    private Layers() {}

    static boolean isWritten(ComponentSymbol component) {
        return Stereotype.find(component.stereotypes(), "layer").isPresent();
    }

    /**
     * Empty for a component that says nothing and contains platform components: it joins the layers
     * and belongs to none.
     */
    static Optional<Layer> of(ComponentSymbol component) {
        boolean joins = !isWritten(component) && !pathToPlatform(component).isEmpty();
        return joins ? Optional.empty() : Optional.of(component.signature().layer());
    }

    /** The instances that lead to a platform component inside; empty if there is none. */
    static List<InstanceSymbol> pathToPlatform(ComponentSymbol component) {
        Set<ComponentSymbol> seen = new HashSet<>();
        Deque<Step> open = new ArrayDeque<>();
        component.instances().forEach(instance -> open.add(new Step(instance, null)));
        while (!open.isEmpty()) {
            Step step = open.poll();
            ComponentSymbol part = step.instance().component().orElse(null);
            if (part != null && part.isPlatform()) {
                return path(step);
            }
            if (part != null && seen.add(part)) {
                part.instances().forEach(instance -> open.add(new Step(instance, step)));
            }
        }
        return List.of();
    }

    private static List<InstanceSymbol> path(Step last) {
        List<InstanceSymbol> path = new ArrayList<>();
        for (Step step = last; step != null; step = step.around()) {
            path.add(0, step.instance());
        }
        return path;
    }
}

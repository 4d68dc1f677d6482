package arcomat.symbols.bodies;

import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSubstitution;

import java.util.ArrayList;
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
        return Resolution.of(current.port(path.get(path.size() - 1)).map(p -> p.with(seen)));
    }

    /**
     * The delay with which messages arrive at an input of a part: that of the output that is
     * connected to it, 0 where none is.
     *
     * @param path at least one instance, then the port
     */
    public static int delayInto(ComponentSymbol component, List<String> path, Delays delays) {
        ComponentSymbol current = component;
        for (String name : path.subList(0, path.size() - 2)) {
            current = current.instance(name).flatMap(InstanceSymbol::component).orElseThrow();
        }
        String key = String.join(".", path.subList(path.size() - 2, path.size()));
        End source = current.connectorTo(key).map(ConnectorSymbol::source).orElse(null);
        if (source == null || source.port().isEmpty()) {
            return 0;
        }
        if (source.instance().isEmpty()) {
            return delayFromOutside(component, path, source.port().get(), delays);
        }
        return source.instance()
                .get()
                .component()
                .map(c -> delays.effective(c, source.port().get()))
                .orElse(0);
    }

    /** The message comes in through a port of the component around the part. */
    private static int delayFromOutside(
            ComponentSymbol component, List<String> path, PortSymbol port, Delays delays) {
        if (path.size() == 2) {
            return 0;
        }
        List<String> around = new ArrayList<>(path.subList(0, path.size() - 2));
        around.add(port.name());
        return delayInto(component, around, delays);
    }
}

package arcomat.editor.answer.flow;

import arcomat.editor.name.Mentions;
import arcomat.pipeline.recheck.ReadModels;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Who is connected with a port, and what has a component for a part, in all models. Only files are
 * looked at in which the name stands: to ask all thousand components after each letter that
 * somebody types would take too long.
 *
 * @param models that are asked
 */
public record PortConnections(ReadModels models) {

    /** Connectors that bring messages to a port, be it its component's own or a part's. */
    public List<ConnectorSymbol> to(PortSymbol port) {
        return at(port).filter(each -> isAt(each.target(), port)).toList();
    }

    /** Connectors that take messages from a port. */
    public List<ConnectorSymbol> from(PortSymbol port) {
        return at(port).filter(each -> isAt(each.source(), port)).toList();
    }

    /**
     * Both, those inside of the components that have the port first. They are found one by one: who
     * needs only some of them does not wait for all.
     */
    public Stream<ConnectorSymbol> at(PortSymbol port) {
        List<ComponentSymbol> owners = withPort(port);
        Set<String> paths = new HashSet<>();
        owners.forEach(each -> Mentions.withWord(models, each.name()).forEach(paths::add));
        Stream<ComponentSymbol> others =
                models.workspace().components().stream()
                        .filter(each -> isIn(paths, each) && !owners.contains(each));
        return Stream.concat(owners.stream(), others)
                .flatMap(PortConnections::written)
                .filter(ConnectorSymbol::isResolved)
                .filter(each -> isAt(each.source(), port) || isAt(each.target(), port));
    }

    public static boolean isAt(ConnectorSymbol.End end, PortSymbol port) {
        return end.port().filter(port::equals).isPresent();
    }

    /** The component that declares a port, and all that inherit it. */
    public List<ComponentSymbol> withPort(PortSymbol port) {
        return models.workspace().components().stream()
                .filter(each -> each.lineage().stream().anyMatch(above -> declares(above, port)))
                .toList();
    }

    private static boolean declares(ComponentSymbol component, PortSymbol port) {
        return component.unit().file() == port.nameSpan().file()
                && component.signature().ownPorts().contains(port);
    }

    private static String path(ComponentSymbol component) {
        return component.unit().file().path();
    }

    /** Who inherits a part may connect it and name nothing but its ports. */
    private static boolean isIn(Set<String> paths, ComponentSymbol component) {
        return component.lineage().stream().anyMatch(each -> paths.contains(path(each)));
    }

    /** Those that it inherits are known from the component above it. */
    private static Stream<ConnectorSymbol> written(ComponentSymbol component) {
        return component.connectors().stream()
                .filter(each -> each.span().file() == component.unit().file());
    }

    /** The parts that are of a component, wherever they are declared. */
    public List<InstanceSymbol> parts(ComponentSymbol component) {
        Set<String> paths = Mentions.withWord(models, component.name()).collect(Collectors.toSet());
        return models.workspace().components().stream()
                .filter(each -> paths.contains(path(each)))
                .flatMap(each -> each.ownInstances().stream())
                .filter(each -> each.component().filter(component::equals).isPresent())
                .toList();
    }
}

package arcomat.check.facts;

import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.ConnectorSymbol.Status;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Questions about the connectors of a component that several laws ask. */
public final class Connections {
    private Connections() {}

    /** The connectors written in a component itself: findings about inherited ones belong there. */
    public static List<ConnectorSymbol> own(ComponentSymbol component) {
        return component.connectors().stream().filter(c -> isOwn(c, component)).toList();
    }

    public static boolean isOwn(ConnectorSymbol connector, ComponentSymbol component) {
        return connector.origin() != ConnectorSymbol.Origin.AUTOMATIC
                && component.node().span().isAround(connector.span());
    }

    /** The keys of all ports at which a connector ends. */
    public static Set<String> usedKeys(ComponentSymbol component) {
        Set<String> used = new HashSet<>();
        for (ConnectorSymbol connector : component.connectors()) {
            used.add(connector.source().key());
            used.add(connector.target().key());
        }
        return used;
    }

    /**
     * Whether some end is misspelled or some part unknown. Then it cannot be told which ports are
     * connected, and nothing should be said about those that seem not to be.
     */
    public static boolean areUnclear(ComponentSymbol component) {
        if (component.lacksAncestor() || lacksPart(component) || MeantParts.mayBeIn(component)) {
            return true;
        }
        return component.connectors().stream()
                .anyMatch(connector -> isWrong(connector.source()) || isWrong(connector.target()));
    }

    private static boolean isWrong(End end) {
        return !end.isResolved() && end.status() != Status.EXCUSED;
    }

    /** Whether the component of some part does not resolve. */
    public static boolean lacksPart(ComponentSymbol component) {
        return component.instances().stream().anyMatch(part -> part.component().isEmpty());
    }
}

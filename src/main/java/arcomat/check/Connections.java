package arcomat.check;

import arcomat.source.Span;
import arcomat.symbols.ComponentReference;
import arcomat.symbols.ComponentSymbol;
import arcomat.symbols.ConnectorSymbol;
import arcomat.symbols.ConnectorSymbol.End;
import arcomat.symbols.ConnectorSymbol.Status;
import arcomat.symbols.InstanceSymbol;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Questions about the connectors of a component that several laws ask. */
final class Connections {
    private Connections() {}

    /** The connectors written in a component itself: findings about inherited ones belong there. */
    static List<ConnectorSymbol> own(ComponentSymbol component) {
        List<ConnectorSymbol> own = new ArrayList<>();
        for (ConnectorSymbol connector : component.connectors()) {
            if (isOwn(connector, component)) {
                own.add(connector);
            }
        }
        return own;
    }

    static boolean isOwn(ConnectorSymbol connector, ComponentSymbol component) {
        return connector.origin() != ConnectorSymbol.Origin.AUTOMATIC
                && contains(component.node().span(), connector.span());
    }

    private static boolean contains(Span outer, Span inner) {
        return outer.file().equals(inner.file())
                && outer.start() <= inner.start()
                && inner.end() <= outer.end();
    }

    /** The keys of all ports at which a connector ends. */
    static Set<String> usedKeys(ComponentSymbol component) {
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
    static boolean areUnclear(ComponentSymbol component) {
        if (lacksAncestor(component) || lacksPart(component)) {
            return true;
        }
        for (ConnectorSymbol connector : component.connectors()) {
            if (isWrong(connector.source()) || isWrong(connector.target())) {
                return true;
            }
        }
        return false;
    }

    private static boolean isWrong(End end) {
        return end.status() != Status.RESOLVED && end.status() != Status.EXCUSED;
    }

    /** Whether the component of some part does not resolve. */
    static boolean lacksPart(ComponentSymbol component) {
        for (InstanceSymbol instance : component.instances()) {
            if (instance.component().isEmpty()) {
                return true;
            }
        }
        return false;
    }

    /** Whether a component further up does not resolve, so that ports may be missing. */
    static boolean lacksAncestor(ComponentSymbol component) {
        List<ComponentSymbol> lineage = component.lineage();
        Optional<ComponentReference> top = lineage.get(lineage.size() - 1).superComponent();
        return top.isPresent() && top.get().component().isEmpty();
    }
}

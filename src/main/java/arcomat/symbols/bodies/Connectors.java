package arcomat.symbols.bodies;

import arcomat.source.ArrayNames;
import arcomat.source.Span;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.ConnectorSymbol.Ends;
import arcomat.symbols.bodies.ConnectorSymbol.Origin;
import arcomat.symbols.bodies.ConnectorSymbol.Status;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.tree.Element;
import arcomat.tree.Name;
import arcomat.tree.Node;
import arcomat.tree.QualifiedName;
import arcomat.tree.Stereotype;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/** Finds the connectors of a component and resolves their ends. */
final class Connectors {
    private final ComponentSymbol component;
    private final List<ConnectorSymbol> found = new ArrayList<>();

    private final Map<String, ConnectorSymbol> byTarget = new HashMap<>();

    private Connectors(ComponentSymbol component) {
        this.component = component;
    }

    static Connectors of(ComponentSymbol component) {
        Connectors connectors = new Connectors(component);
        List<ComponentSymbol> lineage = component.lineage();
        for (int i = lineage.size() - 1; i >= 0; i--) {
            connectors.addWritten(lineage.get(i));
        }
        connectors.found.addAll(Autoconnection.of(component, connectors.found));
        connectors.found.forEach(c -> connectors.byTarget.putIfAbsent(c.target().key(), c));
        return connectors;
    }

    List<ConnectorSymbol> all() {
        return Collections.unmodifiableList(found);
    }

    Optional<ConnectorSymbol> to(String key) {
        return Optional.ofNullable(byTarget.get(key));
    }

    private void addWritten(ComponentSymbol declaring) {
        for (Element.Connector node : declaring.node().elements(Element.Connector.class)) {
            List<End> sources = ends(node.source(), node.source().parts());
            add(Origin.EXPLICIT, node, node.stereotypes(), sources, node.targets());
        }
        for (InstanceSymbol instance : declaring.ownInstances()) {
            for (Element.SimpleConnector node : instance.simpleConnectors()) {
                List<Name> parts = new ArrayList<>();
                parts.add(new Name(instance.nameSpan(), instance.name()));
                parts.addAll(node.source().parts());
                List<End> sources = ends(node.source(), parts);
                add(Origin.SIMPLE, node, node.stereotypes(), sources, node.targets());
            }
        }
    }

    private void add(
            Origin origin,
            Node node,
            List<Stereotype> stereotypes,
            List<End> sources,
            List<QualifiedName> targets) {
        List<Ends> written =
                targets.stream()
                        .flatMap(each -> connected(sources, ends(each, each.parts())).stream())
                        .toList();
        for (Ends ends : sources.size() == 1 ? PartEnds.complete(written) : written) {
            found.add(
                    new ConnectorSymbol(
                            component,
                            origin,
                            node,
                            ends.target().span(),
                            stereotypes,
                            ends.source(),
                            ends.target()));
        }
    }

    /** Several where a whole array is named. */
    private List<End> ends(QualifiedName written, List<Name> parts) {
        End whole = end(written, parts);
        boolean mayBeArray = !whole.isResolved() && whole.status() != Status.EXCUSED;
        List<End> elements =
                mayBeArray
                        ? arrays().elements(parts).stream()
                                .map(each -> end(written, each))
                                .filter(End::isResolved)
                                .toList()
                        : List.of();
        return elements.isEmpty() ? List.of(whole) : elements;
    }

    private WholeArrays arrays() {
        return new WholeArrays(
                name -> component.port(name).isPresent(),
                name -> component.instance(name).isPresent(),
                (part, port) ->
                        component.instance(part).flatMap(each -> each.port(port)).isPresent());
    }

    /** One to one, or one to all of them. */
    private static List<Ends> connected(List<End> sources, List<End> targets) {
        if (sources.size() == 1) {
            return targets.stream().map(target -> new Ends(sources.get(0), target)).toList();
        }
        return sources.size() == targets.size()
                ? IntStream.range(0, sources.size())
                        .mapToObj(each -> new Ends(sources.get(each), targets.get(each)))
                        .toList()
                : List.of(new Ends(otherSize(sources), otherSize(targets)));
    }

    /** Its text is the size; what names nothing has none. */
    private static End otherSize(List<End> ends) {
        End first = ends.get(0);
        String size = Integer.toString(ends.size());
        return first.isResolved()
                ? unresolved(first.span(), size, Status.OTHER_SIZE, Optional.empty())
                : first;
    }

    private End end(QualifiedName written, List<Name> parts) {
        Span span = written.span();
        if (parts.size() == 1) {
            String name = parts.get(0).text();
            Optional<PortSymbol> port = component.port(name);
            return new End(
                    span,
                    name,
                    port.isPresent() ? Status.RESOLVED : Status.NO_SUCH_PORT,
                    port.isPresent() ? Optional.empty() : component.instance(name),
                    port);
        }
        String text = String.join(".", parts.stream().map(Name::text).toList());
        if (parts.size() > 2) {
            return unresolved(span, text, Status.MALFORMED, Optional.empty());
        }
        return endOfInstance(span, text, parts.get(0).text(), parts.get(1).text());
    }

    private End endOfInstance(Span span, String text, String instanceName, String portName) {
        Optional<InstanceSymbol> instance = component.instance(instanceName);
        if (instance.isEmpty()) {
            Status status =
                    isArrayOfUnknown(instanceName) ? Status.EXCUSED : Status.NO_SUCH_INSTANCE;
            return unresolved(span, text, status, instance);
        }
        if (instance.get().component().isEmpty()) {
            return unresolved(span, text, Status.EXCUSED, instance);
        }
        Optional<PortSymbol> port = instance.get().port(portName);
        if (port.isPresent()) {
            return new End(span, text, Status.RESOLVED, instance, port);
        }
        boolean excused = instance.get().component().get().lacksAncestor();
        Status status = excused ? Status.EXCUSED : Status.NO_SUCH_PORT_OF_INSTANCE;
        return unresolved(span, text, status, instance);
    }

    private boolean isArrayOfUnknown(String name) {
        return component
                .instance(ArrayNames.element(name, 0))
                .filter(part -> part.component().map(ComponentSymbol::lacksAncestor).orElse(true))
                .isPresent();
    }

    private static End unresolved(
            Span span, String text, Status status, Optional<InstanceSymbol> instance) {
        return new End(span, text, status, instance, Optional.empty());
    }
}

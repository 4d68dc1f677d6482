package arcomat.symbols.bodies;

import arcomat.source.Span;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.ConnectorSymbol.Ends;
import arcomat.symbols.bodies.ConnectorSymbol.Origin;
import arcomat.symbols.bodies.ConnectorSymbol.Status;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.signatures.Signature;
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
            End source = end(node.source(), node.source().parts());
            add(Origin.EXPLICIT, node, node.stereotypes(), source, node.targets());
        }
        for (InstanceSymbol instance : declaring.ownInstances()) {
            for (Element.SimpleConnector node : instance.simpleConnectors()) {
                List<Name> parts = new ArrayList<>();
                parts.add(new Name(instance.nameSpan(), instance.name()));
                parts.addAll(node.source().parts());
                End source = end(node.source(), parts);
                add(Origin.SIMPLE, node, node.stereotypes(), source, node.targets());
            }
        }
    }

    private void add(
            Origin origin,
            Node node,
            List<Stereotype> stereotypes,
            End source,
            List<QualifiedName> targets) {
        List<Ends> written =
                targets.stream().map(each -> new Ends(source, end(each, each.parts()))).toList();
        for (Ends ends : PartEnds.complete(written)) {
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
            return unresolved(span, text, Status.NO_SUCH_INSTANCE, instance);
        }
        if (instance.get().component().isEmpty()) {
            return unresolved(span, text, Status.EXCUSED, instance);
        }
        Optional<PortSymbol> port = instance.get().port(portName);
        if (port.isPresent()) {
            return new End(span, text, Status.RESOLVED, instance, port);
        }
        boolean excused = lacksAncestor(instance.get().component().get());
        Status status = excused ? Status.EXCUSED : Status.NO_SUCH_PORT_OF_INSTANCE;
        return unresolved(span, text, status, instance);
    }

    /** Whether the port may come from a super component that does not resolve. */
    private static boolean lacksAncestor(ComponentSymbol component) {
        List<Signature> lineage = component.signature().lineage();
        return lineage.get(lineage.size() - 1)
                .superComponent()
                .filter(s -> s.component().isEmpty())
                .isPresent();
    }

    private static End unresolved(
            Span span, String text, Status status, Optional<InstanceSymbol> instance) {
        return new End(span, text, status, instance, Optional.empty());
    }
}

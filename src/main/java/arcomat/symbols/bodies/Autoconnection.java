package arcomat.symbols.bodies;

import arcomat.source.Span;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.ConnectorSymbol.Origin;
import arcomat.symbols.bodies.ConnectorSymbol.Status;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.TypeRules;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Element;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * The connections that {@code autoconnect} makes: between an unused sender and an unused receiver
 * of different instances (the component itself counts as one) where each is the only match of the
 * other.
 */
final class Autoconnection {
    private final ComponentSymbol component;
    private final Element.Autoconnect statement;
    private final List<End> senders = new ArrayList<>();
    private final List<End> receivers = new ArrayList<>();

    private Autoconnection(ComponentSymbol component, Element.Autoconnect statement) {
        this.component = component;
        this.statement = statement;
    }

    static List<ConnectorSymbol> of(ComponentSymbol component, List<ConnectorSymbol> written) {
        Element.Autoconnect statement = statement(component);
        if (statement == null || statement.kind() == Element.AutoconnectKind.OFF) {
            return List.of();
        }
        Autoconnection connection = new Autoconnection(component, statement);
        connection.collectUnused(written);
        return connection.connect();
    }

    /** The last statement of the nearest component that has one. */
    private static Element.@Nullable Autoconnect statement(ComponentSymbol component) {
        for (ComponentSymbol c : component.lineage()) {
            List<Element.Autoconnect> statements = c.node().elements(Element.Autoconnect.class);
            if (!statements.isEmpty()) {
                return statements.get(statements.size() - 1);
            }
        }
        return null;
    }

    private void collectUnused(List<ConnectorSymbol> written) {
        Set<String> used = new HashSet<>();
        for (ConnectorSymbol connector : written) {
            used.add(connector.source().key());
            used.add(connector.target().key());
        }
        component.ports().forEach(port -> addUnused(Optional.empty(), port, used));
        for (InstanceSymbol instance : component.instances()) {
            instance.ports().forEach(port -> addUnused(Optional.of(instance), port, used));
        }
    }

    private void addUnused(Optional<InstanceSymbol> instance, PortSymbol port, Set<String> used) {
        String text = instance.map(i -> i.name() + "." + port.name()).orElse(port.name());
        End end = new End(statement.span(), text, Status.RESOLVED, instance, Optional.of(port));
        if (!used.contains(end.key())) {
            (end.isSender() ? senders : receivers).add(end);
        }
    }

    private List<ConnectorSymbol> connect() {
        boolean byName = statement.kind() == Element.AutoconnectKind.PORT;
        Function<End, Object> key =
                byName ? e -> e.port().get().name() : e -> e.port().get().type().base();
        Map<Object, List<End>> sendersByKey = group(senders, key);
        Map<Object, List<End>> receiversByKey = group(receivers, key);
        List<ConnectorSymbol> made = new ArrayList<>();
        for (End receiver : receivers) {
            Object group = key.apply(receiver);
            Optional<End> sender =
                    only(sendersByKey.getOrDefault(group, List.of()), s -> matches(s, receiver));
            if (sender.isPresent()
                    && only(
                                    receiversByKey.getOrDefault(group, List.of()),
                                    r -> matches(sender.get(), r))
                            .isPresent()) {
                made.add(connector(sender.get(), receiver));
            }
        }
        return made;
    }

    private static Map<Object, List<End>> group(List<End> ends, Function<End, Object> key) {
        Map<Object, List<End>> groups = new HashMap<>();
        ends.forEach(
                end -> groups.computeIfAbsent(key.apply(end), k -> new ArrayList<>()).add(end));
        return groups;
    }

    private static boolean matches(End sender, End receiver) {
        TypeSymbol from = sender.port().get().type();
        TypeSymbol to = receiver.port().get().type();
        return !sender.instance().equals(receiver.instance())
                && !from.isErroneous()
                && !to.isErroneous()
                && TypeRules.fits(from, to);
    }

    /** The only match; stops at the second one, so that large groups cost little. */
    private static Optional<End> only(List<End> ends, Predicate<End> matches) {
        List<End> two = ends.stream().filter(matches).limit(2).toList();
        return two.size() == 1 ? Optional.of(two.get(0)) : Optional.empty();
    }

    private ConnectorSymbol connector(End source, End target) {
        Span span = statement.span();
        return new ConnectorSymbol(
                component, Origin.AUTOMATIC, statement, span, List.of(), source, target);
    }
}

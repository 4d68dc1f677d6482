package arcomat.semantics.invariant;

import arcomat.model.Component;
import arcomat.model.Component.Endpoint;
import arcomat.model.Expression;
import arcomat.model.Invariant;
import arcomat.model.Port;
import arcomat.semantics.invariant.InvariantWatch.Seen;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * A component beside observers that see its ports, and its variables after each step. The parts of
 * a composition become neighbours of the observers; a component without parts is one itself.
 */
final class WatchedComponent {
    private final Component watched;
    private final Invariant invariant;
    private final List<Observer> observers;

    /**
     * A part that looks on.
     *
     * @param component with one output
     * @param seen what its inputs are
     */
    record Observer(Component component, List<Seen> seen) {
        Observer {
            seen = List.copyOf(seen);
        }

        Port broken() {
            return component.outputs().get(0);
        }
    }

    WatchedComponent(Component watched, Invariant invariant, List<Observer> observers) {
        this.watched = watched;
        this.invariant = invariant;
        this.observers = List.copyOf(observers);
    }

    Component together() {
        List<Port> ports = new ArrayList<>(watched.ports());
        observers.forEach(each -> ports.add(each.broken()));
        return watched.like(watched.name(), ports, body(), watched.span());
    }

    private Component.Composite body() {
        List<Component.Part> parts = new ArrayList<>();
        List<Component.Connection> connections = new ArrayList<>();
        Function<String, Optional<Endpoint>> sender;
        if (watched.body() instanceof Component.Composite composite) {
            parts.addAll(composite.parts());
            connections.addAll(composite.connections());
            sender = output -> sender(composite, output);
        } else {
            String inside = watched.name();
            Component shown = withVariables((Component.Atomic) watched.body());
            parts.add(part(inside, shown));
            for (Port input : watched.inputs()) {
                connect(outside(input.name()), inside(inside, input.name()), connections);
            }
            for (Port output : watched.outputs()) {
                connect(inside(inside, output.name()), outside(output.name()), connections);
            }
            sender = output -> Optional.of(inside(inside, output));
        }
        for (Observer observer : observers) {
            add(observer, sender, parts, connections);
        }
        return new Component.Composite(parts, connections);
    }

    private void add(
            Observer observer,
            Function<String, Optional<Endpoint>> sender,
            List<Component.Part> parts,
            List<Component.Connection> connections) {
        String name = observer.component().name();
        parts.add(part(name, observer.component()));
        for (Seen each : observer.seen()) {
            Endpoint target = inside(name, each.input().name());
            source(each, sender).ifPresent(source -> connect(source, target, connections));
        }
        String broken = observer.broken().name();
        connect(inside(name, broken), outside(broken), connections);
    }

    private Optional<Endpoint> source(Seen each, Function<String, Optional<Endpoint>> sender) {
        if (each instanceof InvariantWatch.SeenInside port) {
            return Optional.of(inside(port.part(), port.port()));
        }
        String name = each.input().name();
        if (each instanceof InvariantWatch.SeenVariable) {
            return sender.apply(window(name));
        }
        return watched.port(name).orElseThrow().isInput()
                ? Optional.of(outside(name))
                : sender.apply(name);
    }

    static Optional<Endpoint> sender(Component.Composite whole, String output) {
        return whole.connections().stream()
                .filter(each -> each.target().equals(outside(output)))
                .map(Component.Connection::source)
                .findFirst();
    }

    private static String window(String variable) {
        return "variable " + variable;
    }

    private Component withVariables(Component.Atomic body) {
        List<Port> ports = new ArrayList<>(watched.ports());
        List<Component.Shown> shown = new ArrayList<>();
        for (Port input : seenVariables()) {
            String window = window(input.name());
            ports.add(
                    new Port(
                            window,
                            Port.Direction.OUT,
                            input.type(),
                            true,
                            0,
                            false,
                            input.span()));
            shown.add(new Component.Shown(input.name(), window));
        }
        return watched.like(
                watched.name(),
                ports,
                new Component.Atomic(body.automata(), shown),
                watched.span());
    }

    /** Inputs of observers that are variables, those of one name once. */
    private Collection<Port> seenVariables() {
        Map<String, Port> inputs = new LinkedHashMap<>();
        observers.stream()
                .flatMap(observer -> observer.seen().stream())
                .filter(InvariantWatch.SeenVariable.class::isInstance)
                .forEach(each -> inputs.putIfAbsent(each.input().name(), each.input()));
        return inputs.values();
    }

    /** A part with the arguments of the whole. */
    @SuppressWarnings("NullAway") // they stand nowhere in the text
    private Component.Part part(String name, Component component) {
        List<Expression> arguments = new ArrayList<>();
        component
                .parameters()
                .forEach(each -> arguments.add(new Expression.ParameterRead(each, null)));
        return new Component.Part(name, component, arguments, invariant.span());
    }

    private void connect(Endpoint source, Endpoint target, List<Component.Connection> connections) {
        connections.add(new Component.Connection(source, target, invariant.span()));
    }

    private static Endpoint outside(String port) {
        return new Endpoint(Optional.empty(), port);
    }

    private static Endpoint inside(String part, String port) {
        return new Endpoint(Optional.of(part), port);
    }
}

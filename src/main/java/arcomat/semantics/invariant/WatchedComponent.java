package arcomat.semantics.invariant;

import arcomat.model.Component;
import arcomat.model.Component.Endpoint;
import arcomat.model.Expression;
import arcomat.model.Invariant;
import arcomat.model.Port;
import arcomat.semantics.invariant.InvariantWatch.Seen;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * A component beside an observer that sees its ports, and its variables after each step. The parts
 * of a composition become neighbours of the observer; a component without parts is one itself.
 */
final class WatchedComponent {
    private final Component watched;
    private final Invariant invariant;
    private final Component observer;
    private final List<Seen> seen;

    WatchedComponent(Component watched, Invariant invariant, Component observer, List<Seen> seen) {
        this.watched = watched;
        this.invariant = invariant;
        this.observer = observer;
        this.seen = seen;
    }

    Component together() {
        List<Port> ports = new ArrayList<>(watched.ports());
        ports.add(observer.outputs().get(0));
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
        parts.add(part(observer.name(), observer));
        for (Seen each : seen) {
            source(each, sender)
                    .ifPresent(
                            source ->
                                    connect(
                                            source,
                                            inside(observer.name(), each.input().name()),
                                            connections));
        }
        String broken = observer.outputs().get(0).name();
        connect(inside(observer.name(), broken), outside(broken), connections);
        return new Component.Composite(parts, connections);
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
        for (Seen each : seen) {
            if (each instanceof InvariantWatch.SeenVariable variable) {
                String window = window(variable.input().name());
                Port input = variable.input();
                ports.add(
                        new Port(
                                window,
                                Port.Direction.OUT,
                                input.type(),
                                true,
                                0,
                                false,
                                input.span()));
                shown.add(new Component.Shown(variable.input().name(), window));
            }
        }
        return watched.like(
                watched.name(),
                ports,
                new Component.Atomic(body.automata(), shown),
                watched.span());
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

package arcomat.semantics.network;

import arcomat.model.Component;
import arcomat.model.Component.Endpoint;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.semantics.expression.Substitution;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/** Builds one {@link Composition}: wires the parts, dissolves composites on cycles, orders. */
final class Composer {
    private final Component component;
    private final boolean timed;
    private final Map<Component, Composition> known;
    private final Map<String, Draft> parts = new HashMap<>();
    private final Map<Endpoint, Endpoint> senders = new HashMap<>();
    private final List<Wire> outputs = new ArrayList<>();
    private List<Draft> drafts = new ArrayList<>();

    /** A node whose place in the schedule is still open. */
    static final class Draft {
        final String path;
        final Component component;
        final List<Expression> arguments;
        final Optional<Composition> inside;
        final List<Wire> inputs = new ArrayList<>();
        int position;
        List<Draft> dissolved = List.of();

        Draft(
                String path,
                Component component,
                List<Expression> arguments,
                Optional<Composition> inside) {
            this.path = path;
            this.component = component;
            this.arguments = arguments;
            this.inside = inside;
        }
    }

    /**
     * A source that knows its sender by reference.
     *
     * @param sender null for a port of the whole and for none
     * @param port null for none
     */
    record Wire(@Nullable Draft sender, @Nullable Port port, boolean fresh) {
        static final Wire NONE = new Wire(null, null, false);
    }

    Composer(Component component, Map<Component, Composition> known) {
        this.component = component;
        this.timed = component.profile() == Component.Profile.TIME_SYNCHRONOUS;
        this.known = known;
    }

    Composition compose() {
        Component.Composite body = (Component.Composite) component.body();
        Substitution constants = Substitution.ofConstants(component);
        for (Component.Part part : body.parts()) {
            Draft draft =
                    new Draft(
                            part.name(),
                            part.component(),
                            part.arguments().stream().map(constants::apply).toList(),
                            Composition.inside(part.component(), known));
            drafts.add(draft);
            parts.put(part.name(), draft);
        }
        body.connections().forEach(c -> senders.put(c.target(), c.source()));
        wire();
        if (timed) {
            drafts = new Schedule(component).order(drafts, this::dissolve);
        }
        return finish();
    }

    private void wire() {
        for (Draft draft : drafts) {
            for (Port input : draft.component.inputs()) {
                draft.inputs.add(sender(new Endpoint(Optional.of(draft.path), input.name())));
            }
        }
        for (Port output : component.outputs()) {
            outputs.add(sender(new Endpoint(Optional.empty(), output.name())));
        }
    }

    /** Follows connections, straight through composites that only pass a message on. */
    private Wire sender(Endpoint receiver) {
        Set<Endpoint> seen = new HashSet<>();
        Endpoint source = senders.get(receiver);
        while (source != null && seen.add(source)) {
            if (source.part().isEmpty()) {
                return new Wire(null, component.port(source.port()).orElseThrow(), false);
            }
            Draft draft = Objects.requireNonNull(parts.get(source.part().get()));
            Port port = draft.component.port(source.port()).orElseThrow();
            if (draft.inside.isEmpty()) {
                boolean fresh = timed && port.delay() == 0 && !draft.component.platform();
                return new Wire(draft, port, fresh);
            }
            Source inner = innerSource(draft, port);
            if (inner instanceof Source.FromNode node) {
                return new Wire(draft, port, node.fresh());
            }
            source =
                    inner instanceof Source.FromOutside outside
                            ? senders.get(new Endpoint(source.part(), outside.port().name()))
                            : null;
        }
        return Wire.NONE;
    }

    private static Source innerSource(Draft draft, Port port) {
        for (Composition.Output output : draft.inside.orElseThrow().outputs()) {
            if (output.port().name().equals(port.name())) {
                return output.source();
            }
        }
        throw new IllegalArgumentException(draft.path + " has no output " + port.name());
    }

    /** Replaces composites by their nodes, in their places. */
    private List<Draft> dissolve(List<Draft> all, Set<Draft> composites) {
        List<Draft> replaced = new ArrayList<>();
        for (Draft draft : all) {
            if (composites.contains(draft)) {
                draft.dissolved = nodesOf(draft);
                replaced.addAll(draft.dissolved);
            } else {
                replaced.add(draft);
            }
        }
        replaced.forEach(draft -> draft.inputs.replaceAll(Composer::redirect));
        outputs.replaceAll(Composer::redirect);
        return replaced;
    }

    private static List<Draft> nodesOf(Draft whole) {
        Substitution substitution = new Substitution(whole.component, whole.arguments);
        List<Draft> inner = new ArrayList<>();
        for (Composition.Node node : whole.inside.orElseThrow().nodes()) {
            inner.add(
                    new Draft(
                            whole.path + "." + node.path(),
                            node.component(),
                            node.arguments().stream().map(substitution::apply).toList(),
                            node.inside()));
        }
        Map<String, Wire> outside = new HashMap<>();
        List<Port> ports = whole.component.inputs();
        for (int i = 0; i < ports.size(); i++) {
            outside.put(ports.get(i).name(), whole.inputs.get(i));
        }
        List<Composition.Node> nodes = whole.inside.get().nodes();
        for (int i = 0; i < nodes.size(); i++) {
            for (Source source : nodes.get(i).inputs()) {
                inner.get(i).inputs.add(wire(source, inner, outside));
            }
        }
        return inner;
    }

    private static Wire wire(Source source, List<Draft> inner, Map<String, Wire> outside) {
        return source.match(
                port -> outside.get(port.port().name()),
                node -> new Wire(inner.get(node.node()), node.port(), node.fresh()),
                () -> Wire.NONE);
    }

    @SuppressWarnings("NullAway") // what has a sender has its port
    private static Wire redirect(Wire wire) {
        if (wire.sender == null || wire.sender.dissolved.isEmpty()) {
            return wire;
        }
        Source.FromNode inner = (Source.FromNode) innerSource(wire.sender, wire.port);
        return new Wire(wire.sender.dissolved.get(inner.node()), inner.port(), wire.fresh);
    }

    private Composition finish() {
        Map<Draft, Integer> positions = new IdentityHashMap<>();
        drafts.forEach(draft -> positions.put(draft, positions.size()));
        List<Composition.Node> nodes = new ArrayList<>();
        for (Draft draft : drafts) {
            nodes.add(
                    new Composition.Node(
                            draft.path,
                            draft.component,
                            draft.arguments,
                            draft.inputs.stream().map(w -> source(w, positions)).toList(),
                            draft.inside));
        }
        List<Composition.Output> targets = new ArrayList<>();
        for (Port port : component.outputs()) {
            targets.add(
                    new Composition.Output(port, source(outputs.get(targets.size()), positions)));
        }
        return new Composition(component, nodes, targets);
    }

    private static Source source(Wire wire, Map<Draft, Integer> positions) {
        if (wire.port == null) {
            return new Source.Unconnected();
        }
        return wire.sender == null
                ? new Source.FromOutside(wire.port)
                : new Source.FromNode(
                        Objects.requireNonNull(positions.get(wire.sender)), wire.port, wire.fresh);
    }
}

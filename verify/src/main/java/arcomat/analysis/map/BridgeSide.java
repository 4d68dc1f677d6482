package arcomat.analysis.map;

import arcomat.model.Component;
import arcomat.model.Component.Connection;
import arcomat.model.Component.Endpoint;
import arcomat.model.Component.Part;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** A component as a part of a composition that is made for a comparison, with its neighbours. */
final class BridgeSide {
    private final Promise promise;
    private final Part part;
    private final List<Part> parts = new ArrayList<>();
    private final List<Connection> connections = new ArrayList<>();

    BridgeSide(Promise promise) {
        this.promise = promise;
        String simple = InterfaceMap.simpleName(promise.component());
        this.part =
                add(simple.substring(0, 1).toLowerCase(Locale.ROOT) + simple.substring(1), promise);
    }

    /** A port that a message may come from. */
    record Offer(Port port, Endpoint endpoint) {}

    /** What counts of the component, as a part. */
    Component component() {
        return part.component();
    }

    String title() {
        return promise.title();
    }

    /** One more part, under that name or, where a part has it, one like it. */
    Part add(String name, Promise promised) {
        Component added = asPart(promised);
        List<Expression> arguments = new ArrayList<>();
        for (int i = 0; i < promised.arguments().size(); i++) {
            Value value = promised.arguments().get(i);
            arguments.add(
                    new Expression.Constant(value, added.parameters().get(i).type(), added.span()));
        }
        boolean taken = parts.stream().anyMatch(each -> each.name().equals(name));
        Part made = new Part(taken ? name + "OfMap" : name, added, arguments, added.span());
        parts.add(made);
        return made;
    }

    /**
     * Of some automata only the ports that they decide about: about others they say nothing, and a
     * part on which nothing else stands would keep them silent.
     */
    private static Component asPart(Promise promised) {
        Component whole = promised.component();
        if (promised.isComposition() || promised.automata().isEmpty()) {
            return whole;
        }
        Set<String> decided = new HashSet<>();
        promised.automata().forEach(each -> decided.addAll(ComponentSemantics.owned(whole, each)));
        List<Port> ports =
                whole.ports().stream()
                        .filter(port -> port.isInput() || decided.contains(port.name()))
                        .toList();
        return whole.like(
                whole.name(), ports, new Component.Atomic(promised.automata()), whole.span());
    }

    void connect(Endpoint source, Endpoint target) {
        connections.add(new Connection(source, target, component().span()));
    }

    Endpoint endpoint(Port port) {
        return endpoint(part, port);
    }

    static Endpoint endpoint(Part part, Port port) {
        return new Endpoint(Optional.of(part.name()), port.name());
    }

    Offer offer(Port output) {
        return offer(part, output);
    }

    static Offer offer(Part part, Port output) {
        return new Offer(output, endpoint(part, output));
    }

    static Offer outside(Port input) {
        return new Offer(input, new Endpoint(Optional.empty(), input.name()));
    }

    /** The composition, under the name of the component that it is about. */
    Promise whole(List<Port> ports) {
        Component component = component();
        Component whole =
                new Component(
                        component.packageName(),
                        component.name(),
                        component.layer(),
                        false,
                        false,
                        component.profile(),
                        component.queueCapacity(),
                        component.cycle(),
                        List.of(),
                        List.of(),
                        ports,
                        new Component.Composite(parts, connections),
                        List.of(),
                        List.of(),
                        List.of(),
                        component.span());
        return new Promise(whole, List.of(), List.of()).marked(mark());
    }

    /** Arguments, or an automaton: what its own title says behind the component's name. */
    private String mark() {
        String qualified = component().qualifiedName();
        return title().startsWith(qualified) ? title().substring(qualified.length()) : "";
    }
}

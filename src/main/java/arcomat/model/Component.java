package arcomat.model;

import arcomat.source.Span;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A component type after specialisation: inherited parts are folded in, type parameters replaced.
 *
 * @param packageName empty for the default package
 * @param name the simple name; inner components are named {@code Outer.Inner}, an instantiation of
 *     a generic component carries its type arguments, {@code Buffer<Integer>}. Unique in its
 *     package.
 * @param cycle length of a slice in milliseconds, where this component is a main component
 * @param requirements automata on a decomposed component: they constrain it, they do not run
 * @param refines qualified names of the components whose promises this one keeps
 * @param invariants those that have a meaning here
 */
public record Component(
        String packageName,
        String name,
        Layer layer,
        boolean platform,
        boolean deploy,
        Profile profile,
        int queueCapacity,
        int cycle,
        List<Parameter> parameters,
        List<Variable> constants,
        List<Port> ports,
        Body body,
        List<Automaton> requirements,
        List<String> refines,
        List<Invariant> invariants,
        Span span) {
    public Component {
        parameters = List.copyOf(parameters);
        constants = List.copyOf(constants);
        ports = List.copyOf(ports);
        requirements = List.copyOf(requirements);
        refines = List.copyOf(refines);
        invariants = List.copyOf(invariants);
    }

    /** What a component is made of. */
    public sealed interface Body {}

    /**
     * Behaviour of its own. Without automata nothing is said about it; several are a conjunction,
     * each has to be satisfied.
     *
     * @param shown variables that an analysis makes visible
     */
    public record Atomic(List<Automaton> automata, List<Shown> shown) implements Body {
        public Atomic {
            automata = List.copyOf(automata);
            shown = List.copyOf(shown);
        }

        /** Whose variables nobody sees, as in all that is written in models. */
        public Atomic(List<Automaton> automata) {
            this(automata, List.of());
        }
    }

    /**
     * A variable that can be seen: after each step the port, an output without delay that carries a
     * message in every slice and that no automaton writes, has its value.
     *
     * @param variable of one automaton only
     */
    public record Shown(String variable, String port) {}

    public record Composite(List<Part> parts, List<Connection> connections) implements Body {
        public Composite {
            parts = List.copyOf(parts);
            connections = List.copyOf(connections);
        }
    }

    /**
     * An instance of a component inside another.
     *
     * @param arguments one per parameter of the part's component, over the parameters of the whole
     */
    public record Part(String name, Component component, List<Expression> arguments, Span span) {
        public Part {
            arguments = List.copyOf(arguments);
        }
    }

    /** One sender and one receiver; a connector with several targets is several connections. */
    public record Connection(Endpoint source, Endpoint target, Span span) {}

    /**
     * A port of a part, or of the whole.
     *
     * @param part empty for the whole
     */
    public record Endpoint(Optional<String> part, String port) {
        @Override
        public String toString() {
            return part.map(p -> p + "." + port).orElse(port);
        }
    }

    /** The three layers of a robot program (the paper, section 4). */
    public enum Layer {
        SENSORS,
        LOGIC,
        ACTUATORS
    }

    /** How time passes: one letter per slice, or one event per step. */
    public enum Profile {
        TIME_SYNCHRONOUS,
        EVENT_DRIVEN;

        /** Whether a port may carry no message; total ports may before an event has come. */
        public boolean mayBeSilent(Port port) {
            return port.first().isEmpty() && !(port.total() && this == TIME_SYNCHRONOUS);
        }
    }

    /**
     * Another component that is made for this one, with its parameters and constants: no platform
     * component, never deployed, and it keeps no promises of others.
     */
    public Component like(String otherName, List<Port> otherPorts, Body otherBody, Span place) {
        return new Component(
                packageName,
                otherName,
                layer,
                false,
                false,
                profile,
                queueCapacity,
                cycle,
                parameters,
                constants,
                otherPorts,
                otherBody,
                List.of(),
                List.of(),
                List.of(),
                place);
    }

    public String qualifiedName() {
        return packageName.isEmpty() ? name : packageName + "." + name;
    }

    /**
     * The component as automata on it see it: a decomposed one sends with the delays that are
     * written down, whatever its parts do.
     */
    public Component asPromised() {
        return ports.stream().allMatch(port -> port.delay() == port.promised())
                ? this
                : new Component(
                        packageName,
                        name,
                        layer,
                        platform,
                        deploy,
                        profile,
                        queueCapacity,
                        cycle,
                        parameters,
                        constants,
                        ports.stream().map(Port::asPromised).toList(),
                        body,
                        requirements,
                        refines,
                        invariants,
                        span);
    }

    /** Those of its behaviour, or the requirements on a decomposed one. */
    public List<Automaton> automata() {
        return body instanceof Atomic atomic ? atomic.automata() : requirements;
    }

    /** The qualified name, with that of the automaton where it is one of several. */
    public String title(Automaton automaton) {
        boolean several = automata().size() > 1 && !automaton.name().isEmpty();
        return qualifiedName() + (several ? "#" + automaton.name() : "");
    }

    /** Whether an instance may leave out all arguments. */
    public boolean hasDefaults() {
        return parameters.stream().allMatch(parameter -> parameter.initial().isPresent());
    }

    /**
     * Whether statements of it, or of a part, are one transition whose effect is said by nothing
     * else: it can be run, but not be looked at.
     */
    public boolean isOnlyRun() {
        return isOnlyRun(new HashSet<>());
    }

    private boolean isOnlyRun(Set<String> seen) {
        if (!seen.add(qualifiedName())) {
            return false;
        }
        return automata().stream().anyMatch(Component::isOnlyRun)
                || body instanceof Composite composite
                        && composite.parts().stream()
                                .anyMatch(part -> part.component().isOnlyRun(seen));
    }

    private static boolean isOnlyRun(Automaton automaton) {
        return automaton.transitions().stream().anyMatch(Automaton.Transition::isWhole);
    }

    public boolean isComposite() {
        return body instanceof Composite;
    }

    public List<Port> inputs() {
        return ports.stream().filter(Port::isInput).toList();
    }

    public List<Port> outputs() {
        return ports.stream().filter(p -> !p.isInput()).toList();
    }

    public Optional<Port> port(String portName) {
        return ports.stream().filter(p -> p.name().equals(portName)).findFirst();
    }
}

package arcomat.semantics;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.TooManyWays;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * One side of a comparison: a component, or some automata on it.
 *
 * @param component with the delays that are written down where its automata count
 * @param arguments one per parameter
 * @param automata those that count; empty for a composition, which is what its parts make it
 * @param devices of a composition, whether what its platform components send and receive is looked
 *     at, too
 * @param mark what follows its title, to tell it from its namesake in other models
 */
public record Promise(
        Component component,
        List<Value> arguments,
        List<Automaton> automata,
        boolean devices,
        String mark) {
    public Promise {
        component = automata.isEmpty() ? component : component.asPromised();
        arguments = List.copyOf(arguments);
        automata = List.copyOf(automata);
        if (component.isOnlyRun()) {
            throw new TooManyWays();
        }
    }

    public Promise(Component component, List<Value> arguments, List<Automaton> automata) {
        this(component, arguments, automata, false, "");
    }

    /** What a component does. */
    public static Promise of(Component component, List<Value> arguments) {
        List<Automaton> automata =
                component.body() instanceof Component.Atomic atomic ? atomic.automata() : List.of();
        return new Promise(component, arguments, automata);
    }

    /** What the automata on a decomposed component ask of it. */
    public static Promise required(Component component, List<Value> arguments) {
        return new Promise(component, arguments, component.requirements());
    }

    /** The same with one automaton only, by its name. */
    public Optional<Promise> only(String automaton) {
        List<Automaton> named =
                component.automata().stream().filter(a -> a.name().equals(automaton)).toList();
        return named.isEmpty()
                ? Optional.empty()
                : Optional.of(new Promise(component, arguments, named));
    }

    /** The same with another completion. */
    public Promise with(Automaton.Completion completion) {
        return withAutomata(automata.stream().map(a -> a.with(completion)).toList());
    }

    /** The same with other automata, made from its own. */
    public Promise withAutomata(List<Automaton> others) {
        return new Promise(component, arguments, others, devices, mark);
    }

    /**
     * Each automaton on its own: a conjunction allows what each of them does, errors included, so
     * it is kept if each of them is.
     */
    public List<Promise> each() {
        return automata.size() < 2
                ? List.of(this)
                : automata.stream()
                        .map(a -> new Promise(component, arguments, List.of(a), devices, mark))
                        .toList();
    }

    public boolean isComposition() {
        return component.isComposite() && automata.isEmpty();
    }

    /** The parts of a composition, and how they are connected. */
    public Network network() {
        return Network.of(component, arguments);
    }

    /** The same with a look at devices. */
    public Promise withDevices() {
        return new Promise(component, arguments, automata, true, mark);
    }

    /** The same with a mark behind its title. */
    public Promise marked(String text) {
        return new Promise(component, arguments, automata, devices, text);
    }

    /** What can be seen of it; ports of devices are named by their path, {@code left.value}. */
    public List<Port> ports() {
        return devices ? withDevices(Port.Direction.IN, Port.Direction.OUT) : component.ports();
    }

    /**
     * What a side needs to be compared with it: what can be seen, and what its sensors send, which
     * its parts read whoever looks.
     */
    public List<Port> drivenPorts() {
        return devices ? ports() : withDevices(Port.Direction.IN);
    }

    /** Without arguments only the ports of the component itself are known. */
    private List<Port> withDevices(Port.Direction... directions) {
        if (!isComposition() || arguments.size() != component.parameters().size()) {
            return component.ports();
        }
        Network network = network();
        List<Port> ports = new ArrayList<>(component.ports());
        for (Port.Direction direction : directions) {
            boolean in = direction == Port.Direction.IN;
            (in ? network.inputs() : network.outputs())
                    .stream()
                            .skip((in ? component.inputs() : component.outputs()).size())
                            .map(each -> seen(each, direction))
                            .forEach(ports::add);
        }
        return ports;
    }

    /** From the outside a sensor is an input. */
    private static Port seen(Network.External external, Port.Direction direction) {
        Port port = external.port();
        return new Port(
                external.name(),
                direction,
                port.type(),
                port.total(),
                port.delay(),
                port.promised(),
                port.latched(),
                port.first(),
                port.span());
    }

    /**
     * Why it cannot begin: a value that it starts with may be none of its type. Empty if it can.
     *
     * @param goOn asked on the way; it may throw what ends the work
     */
    public Optional<String> obstacle(Runnable goOn) {
        try {
            List<ComponentSemantics> all =
                    isComposition()
                            ? ComponentSemantics.ofParts(network(), goOn)
                            : List.of(behaviour());
            all.forEach(ComponentSemantics::starts);
            return Optional.empty();
        } catch (Fault fault) {
            return Optional.of(
                    "the model goes wrong before it reads anything: " + fault.getMessage());
        }
    }

    public ComponentSemantics behaviour() {
        return ComponentSemantics.of(component, automata, arguments);
    }

    /**
     * The component's name, its arguments, and the automaton's where it is one of several, or where
     * the name alone would stand for the parts of a composition.
     */
    public String title() {
        boolean required = automata.size() == 1 && component.isComposite();
        boolean part = required || automata.size() == 1 && component.automata().size() > 1;
        String name = part ? automata.get(0).name() : "";
        String title = title(component, arguments) + (name.isEmpty() ? "" : "#" + name) + mark;
        return required && name.isEmpty() ? "what " + title + " requires" : title;
    }

    /** {@code p.Timer(3, 5)}; without brackets where there are no arguments. */
    public static String title(Component component, List<Value> arguments) {
        return component.qualifiedName() + listed(arguments);
    }

    private static String listed(List<Value> arguments) {
        return arguments.isEmpty()
                ? ""
                : arguments.stream()
                        .map(Value::toString)
                        .collect(Collectors.joining(", ", "(", ")"));
    }
}

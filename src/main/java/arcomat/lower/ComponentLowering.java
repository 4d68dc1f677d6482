package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Parameter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.Delays;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.TypeSubstitution;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** Components, each instantiation once, parts before wholes. */
final class ComponentLowering {
    private final Delays delays;
    private final Runnable goOn;
    private final Map<Instantiation, Component> lowered = new LinkedHashMap<>();
    private final Map<Instantiation, Environment> environments = new HashMap<>();

    /**
     * @param goOn asked before each component
     */
    ComponentLowering(Delays delays, Runnable goOn) {
        this.delays = delays;
        this.goOn = goOn;
    }

    Collection<Component> lowered() {
        return lowered.values();
    }

    /** The component of an instantiation; lowers what it is made of first, without recursion. */
    Component lower(Instantiation wanted) {
        Deque<Instantiation> open = new ArrayDeque<>();
        open.push(wanted);
        while (!open.isEmpty()) {
            Instantiation current = open.peek();
            int before = open.size();
            if (!lowered.containsKey(current)) {
                pushMissingParts(current, open);
            }
            if (open.size() == before) {
                open.pop();
                if (!lowered.containsKey(current)) {
                    lowered.put(current, build(current));
                }
            }
        }
        return Objects.requireNonNull(lowered.get(wanted));
    }

    private void pushMissingParts(Instantiation whole, Deque<Instantiation> open) {
        for (InstanceSymbol instance : whole.component().instances()) {
            Instantiation part = whole.of(instance);
            if (!lowered.containsKey(part)) {
                open.push(part);
            }
        }
    }

    /** The names inside a lowered component. */
    Environment environment(Instantiation instantiation) {
        return Objects.requireNonNull(environments.get(instantiation));
    }

    Component lowered(Instantiation instantiation) {
        return Objects.requireNonNull(lowered.get(instantiation));
    }

    private Component build(Instantiation instantiation) {
        goOn.run();
        ComponentSymbol symbol = instantiation.component();
        List<Port> ports = ports(instantiation);
        Environment types = Environment.of(instantiation.substitution());
        List<Parameter> parameters = parameters(symbol.parameters(), types);
        Environment outer = SuperArguments.settle(symbol, types.withParameters(parameters));
        List<Variable> constants = VariableLowering.lower(constants(symbol), outer);
        Environment inside = outer.withConstants(constants).withPorts(ports);
        environments.put(instantiation, inside);
        List<Automaton> automata = automata(symbol, inside);
        boolean decomposed = symbol.isDecomposed();
        Component.Body body =
                decomposed
                        ? new CompositionLowering(this, instantiation, inside).lower()
                        : new Component.Atomic(automata);
        return new Component(
                symbol.unit().packageText(),
                instantiation.name(),
                Stereotypes.layer(symbol.signature().layer()),
                symbol.isPlatform(),
                symbol.signature().isDeploy(),
                profile(symbol),
                Stereotypes.queueCapacity(symbol),
                Stereotypes.cycle(symbol),
                parameters,
                constants,
                ports,
                body,
                decomposed ? automata : List.of(),
                refines(symbol),
                InvariantLowering.lower(symbol, body, inside),
                symbol.node().span());
    }

    private static List<VariableSymbol> constants(ComponentSymbol symbol) {
        List<VariableSymbol> constants = new ArrayList<>(symbol.signature().variables());
        constants.removeAll(symbol.fields());
        return constants;
    }

    private static List<Automaton> automata(ComponentSymbol symbol, Environment environment) {
        return symbol.automata().stream()
                .map(each -> new AutomatonLowering(each, environment, profile(symbol)).lower())
                .toList();
    }

    private static List<String> refines(ComponentSymbol symbol) {
        return symbol.signature().refines().stream()
                .map(r -> Lowering.resolved(r.resolution(), r.node()).qualifiedName())
                .toList();
    }

    private static Component.Profile profile(ComponentSymbol symbol) {
        return symbol.isEventDriven()
                ? Component.Profile.EVENT_DRIVEN
                : Component.Profile.TIME_SYNCHRONOUS;
    }

    /** Inherited ports that are declared again stand where they stood. */
    private List<Port> ports(Instantiation instantiation) {
        Map<String, Port> ports = new LinkedHashMap<>();
        Environment types = Environment.of(instantiation.substitution());
        for (PortSymbol port : instantiation.component().ports()) {
            int delay = port.isInput() ? 0 : delays.effective(instantiation.component(), port);
            ports.put(port.name(), port(port, types, delay));
        }
        return List.copyOf(ports.values());
    }

    private static Port port(PortSymbol symbol, Environment types, int delay) {
        Type type = types.type(symbol.type());
        return new Port(
                symbol.name(),
                symbol.isInput() ? Port.Direction.IN : Port.Direction.OUT,
                type,
                symbol.isTotal(),
                delay,
                symbol.delay(),
                symbol.isLatched(),
                symbol.first().flatMap(first -> WrittenMessages.lower(first, symbol.type(), type)),
                symbol.nameSpan());
    }

    private static List<Parameter> parameters(
            List<ParameterSymbol> symbols, Environment environment) {
        List<Parameter> parameters = new ArrayList<>();
        Environment current = environment;
        for (ParameterSymbol symbol : symbols) {
            ExpressionLowering expressions = new ExpressionLowering(current);
            var type = current.type(symbol.type());
            Parameter parameter =
                    new Parameter(
                            symbol.name(),
                            type,
                            symbol.initial().map(initial -> expressions.lower(initial, type)));
            parameters.add(parameter);
            current = current.withParameters(List.of(parameter));
        }
        return parameters;
    }

    /** A bare automaton as an atomic component of its own. */
    Component bare(AutomatonSymbol symbol) {
        Environment types = Environment.of(TypeSubstitution.NONE);
        List<Port> ports = symbol.ports().stream().map(p -> port(p, types, p.delay())).toList();
        Environment inside = types.withPorts(ports);
        return new Component(
                symbol.unit().packageText(),
                symbol.name().isEmpty() ? fileName(symbol) : symbol.name(),
                Component.Layer.LOGIC,
                false,
                false,
                Component.Profile.TIME_SYNCHRONOUS,
                Stereotypes.DEFAULT_CAPACITY,
                Stereotypes.DEFAULT_CYCLE,
                List.of(),
                List.of(),
                ports,
                new Component.Atomic(
                        List.of(
                                new AutomatonLowering(
                                                symbol, inside, Component.Profile.TIME_SYNCHRONOUS)
                                        .lower())),
                List.of(),
                List.of(),
                List.of(),
                symbol.node().span());
    }

    private static String fileName(AutomatonSymbol symbol) {
        String path = symbol.unit().file().path();
        String name = path.substring(path.lastIndexOf('/') + 1);
        return name.substring(0, name.indexOf('.'));
    }
}

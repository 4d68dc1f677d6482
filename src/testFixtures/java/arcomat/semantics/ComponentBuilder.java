package arcomat.semantics;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Writes models in few words: {@code on("driving -> waiting", "frontUS = tooClose", "cmd = stop")}.
 * A message is a constant of the port's type, {@code --} or {@code ?}.
 */
public final class ComponentBuilder {
    public static final Span NOWHERE = new Span(new SourceFile("test", ""), 0, 0);
    public static final Type BOOLEAN = new Type.BooleanType();
    public static final Type INTEGER = Type.IntegerType.of(Type.Width.INT);
    public static final Type.EnumType MOTOR = enumeration("MotorCmd", "fwd", "stop", "backRight");
    public static final Type.EnumType DISTANCE = enumeration("Distance", "clear", "tooClose");
    public static final Type.EnumType COMMAND = enumeration("TimerCmd", "delay");
    public static final Type.EnumType SIGNAL = enumeration("TimerSignal", "alert");
    public static final Type.EnumType LINE = enumeration("LineStatus", "ok", "lost");

    private final String name;
    private Component.Profile profile = Component.Profile.TIME_SYNCHRONOUS;
    private int capacity = 16;
    private boolean platform;
    private final List<Parameter> parameters = new ArrayList<>();
    private final List<Variable> constants = new ArrayList<>();
    private final List<Port> ports = new ArrayList<>();
    private final List<Automaton> automata = new ArrayList<>();
    private final List<Component.Part> parts = new ArrayList<>();
    private final List<Component.Connection> connections = new ArrayList<>();

    private ComponentBuilder(String name) {
        this.name = name;
    }

    public static ComponentBuilder component(String name) {
        return new ComponentBuilder(name);
    }

    public static Type.EnumType enumeration(String name, String... constants) {
        return new Type.EnumType("coffee.Types." + name, List.of(constants));
    }

    public static Type range(int low, int high) {
        return new Type.IntegerType(Type.Width.INT, low, high, true);
    }

    public ComponentBuilder in(Type type, String portName) {
        return port(portName, Port.Direction.IN, type, false, 0, false);
    }

    public ComponentBuilder totalIn(Type type, String portName) {
        return port(portName, Port.Direction.IN, type, true, 0, false);
    }

    public ComponentBuilder latchedIn(Type type, String portName) {
        return port(portName, Port.Direction.IN, type, false, 0, true);
    }

    /** An output with delay 1. */
    public ComponentBuilder out(Type type, String portName) {
        return port(portName, Port.Direction.OUT, type, false, 1, false);
    }

    public ComponentBuilder instantOut(Type type, String portName) {
        return port(portName, Port.Direction.OUT, type, false, 0, false);
    }

    public ComponentBuilder totalOut(Type type, String portName) {
        return port(portName, Port.Direction.OUT, type, true, 1, false);
    }

    private ComponentBuilder port(
            String portName,
            Port.Direction direction,
            Type type,
            boolean total,
            int delay,
            boolean latched) {
        ports.add(new Port(portName, direction, type, total, delay, latched, NOWHERE));
        return this;
    }

    public ComponentBuilder parameter(Type type, String parameterName) {
        return parameter(new Parameter(parameterName, type, Optional.empty()));
    }

    public ComponentBuilder parameter(Parameter parameter) {
        parameters.add(parameter);
        return this;
    }

    public ComponentBuilder constant(Type type, String constantName, Expression value) {
        constants.add(new Variable(constantName, type, value, NOWHERE));
        return this;
    }

    public ComponentBuilder eventDriven() {
        profile = Component.Profile.EVENT_DRIVEN;
        return this;
    }

    public ComponentBuilder queueCapacity(int events) {
        capacity = events;
        return this;
    }

    public ComponentBuilder platform() {
        platform = true;
        return this;
    }

    public ComponentBuilder part(String partName, Component component, Expression... arguments) {
        parts.add(new Component.Part(partName, component, List.of(arguments), NOWHERE));
        return this;
    }

    /**
     * {@code connect("left.value", "control.light")}; a name without a dot is a port of the whole.
     */
    public ComponentBuilder connect(String source, String target) {
        connections.add(new Component.Connection(endpoint(source), endpoint(target), NOWHERE));
        return this;
    }

    private static Component.Endpoint endpoint(String text) {
        int dot = text.indexOf('.');
        return dot < 0
                ? new Component.Endpoint(Optional.empty(), text)
                : new Component.Endpoint(
                        Optional.of(text.substring(0, dot)), text.substring(dot + 1));
    }

    public AutomatonBuilder automaton(Completion completion, String... states) {
        return new AutomatonBuilder(completion, List.of(states));
    }

    public Component build() {
        Component.Body body =
                parts.isEmpty()
                        ? new Component.Atomic(automata)
                        : new Component.Composite(parts, connections);
        return new Component(
                "coffee",
                name,
                Component.Layer.LOGIC,
                platform,
                false,
                profile,
                capacity,
                100,
                parameters,
                constants,
                ports,
                body,
                parts.isEmpty() ? List.of() : automata,
                List.of(),
                List.of(),
                NOWHERE);
    }

    public Port port(String portName) {
        return ports.stream().filter(p -> p.name().equals(portName)).findFirst().orElseThrow();
    }

    public Expression read(String portName) {
        return new Expression.PortRead(port(portName), NOWHERE);
    }

    public static Expression constant(Type type, String text) {
        return new Expression.Constant(value(type, text), type, NOWHERE);
    }

    public static Value value(Type type, String text) {
        if (type instanceof Type.EnumType enumeration) {
            return new Value.EnumValue(enumeration, enumeration.constants().indexOf(text));
        }
        return type instanceof Type.BooleanType
                ? new Value.BooleanValue(Boolean.parseBoolean(text))
                : new Value.IntegerValue(Long.parseLong(text));
    }

    /** One automaton of the component; {@link #end} leads back. */
    public final class AutomatonBuilder {
        private final Completion completion;
        private final List<String> states;
        private Automaton.Omitted omitted = Automaton.Omitted.SILENT;
        private final List<Variable> variables = new ArrayList<>();
        private final List<Automaton.Initial> initials = new ArrayList<>();
        private final List<Automaton.Transition> transitions = new ArrayList<>();

        private AutomatonBuilder(Completion completion, List<String> states) {
            this.completion = completion;
            this.states = states;
        }

        public AutomatonBuilder free() {
            omitted = Automaton.Omitted.FREE;
            return this;
        }

        public AutomatonBuilder variable(Type type, String variableName, String initial) {
            Expression value = constant(type, initial);
            variables.add(new Variable(variableName, type, value, NOWHERE));
            return this;
        }

        public Expression variable(String variableName) {
            return new Expression.VariableRead(find(variableName), NOWHERE);
        }

        private Variable find(String variableName) {
            return variables.stream()
                    .filter(v -> v.name().equals(variableName))
                    .findFirst()
                    .orElseThrow();
        }

        public AutomatonBuilder initial(String state, String output) {
            List<Automaton.Send> sends = sends(output);
            initials.add(new Automaton.Initial(states.indexOf(state), sends, List.of(), NOWHERE));
            return this;
        }

        public AutomatonBuilder on(String move, String input, String output) {
            return on(move, input, null, sends(output), List.of());
        }

        public AutomatonBuilder on(
                String move,
                String input,
                Expression guard,
                List<Automaton.Send> sends,
                List<Automaton.Assignment> assignments) {
            String[] ends = move.split(" -> ");
            transitions.add(
                    new Automaton.Transition(
                            states.indexOf(ends[0]),
                            states.indexOf(ends[ends.length - 1]),
                            Optional.ofNullable(guard),
                            matches(input),
                            sends,
                            assignments,
                            NOWHERE));
            return this;
        }

        public Automaton.Assignment assign(String variableName, Expression value) {
            return new Automaton.Assignment(find(variableName), value);
        }

        public Automaton.Send send(String portName, Expression value) {
            return new Automaton.Send(port(portName), new Automaton.Messages(List.of(value)));
        }

        private List<Automaton.Match> matches(String text) {
            List<Automaton.Match> matches = new ArrayList<>();
            for (String[] item : items(text)) {
                matches.add(new Automaton.Match(port(item[0]), pattern(port(item[0]), item[1])));
            }
            return matches;
        }

        private Automaton.Pattern pattern(Port port, String text) {
            if (text.equals("--")) {
                return new Automaton.Absent();
            }
            return text.equals("?")
                    ? new Automaton.Present()
                    : new Automaton.OneOf(constants(port, text));
        }

        public List<Automaton.Send> sends(String text) {
            List<Automaton.Send> sends = new ArrayList<>();
            for (String[] item : items(text)) {
                Port port = port(item[0]);
                Automaton.Emission emission =
                        switch (item[1]) {
                            case "--" -> new Automaton.Silence();
                            case "?" -> new Automaton.AnyMessage();
                            default -> new Automaton.Messages(constants(port, item[1]));
                        };
                sends.add(new Automaton.Send(port, emission));
            }
            return sends;
        }

        /** Values of one port, separated by a bar. */
        private static List<Expression> constants(Port port, String text) {
            return Arrays.stream(text.split("\\|")).map(v -> constant(port.type(), v)).toList();
        }

        private static List<String[]> items(String text) {
            return text.isEmpty()
                    ? List.of()
                    : Arrays.stream(text.split(", ")).map(item -> item.split(" = ")).toList();
        }

        public ComponentBuilder end() {
            automata.add(
                    new Automaton(
                            "",
                            completion,
                            omitted,
                            states,
                            variables,
                            initials,
                            transitions,
                            NOWHERE));
            return ComponentBuilder.this;
        }

        public Component build() {
            return end().build();
        }
    }
}

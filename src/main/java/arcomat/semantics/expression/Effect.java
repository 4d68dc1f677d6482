package arcomat.semantics.expression;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Assignment;
import arcomat.model.Automaton.Send;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;

/** The right-hand side of a transition or initial clause, ready to be carried out. */
public final class Effect {
    private record Update(int slot, String name, Type type, Term value) {}

    private record Emission(String name, Type type, List<Term> values) {}

    private final List<Update> updates = new ArrayList<>();

    /** Per output port what is always sent, or null where it has to be computed. */
    private final List<Sent> fixed = new ArrayList<>();

    private final List<Emission> computed = new ArrayList<>();
    private final @Nullable Output constantOutput;

    /**
     * @param owned names of the output ports that the automaton decides about
     */
    public Effect(
            Component component,
            Automaton automaton,
            Set<String> owned,
            List<Send> sends,
            List<Assignment> assignments,
            Scope scope) {
        boolean constant = true;
        for (Port port : component.outputs()) {
            Sent sent =
                    owned.contains(port.name()) ? fixed(port, sends, automaton) : anything(port);
            fixed.add(sent);
            computed.add(sent == null ? emission(port, sends, scope) : null);
            constant &= sent != null;
        }
        constantOutput = constant ? new Output(fixed) : null;
        for (Assignment assignment : assignments) {
            updates.add(
                    new Update(
                            scope.variable(assignment.variable()),
                            assignment.variable().name(),
                            assignment.variable().type(),
                            Evaluation.compile(assignment.value(), scope)));
        }
    }

    /** Any message where a port carries one in every slice, else anything. */
    public static Sent anything(Port port) {
        return port.total() ? new Sent.AnyMessage() : new Sent.Anything();
    }

    private static @Nullable Send send(Port port, List<Send> sends) {
        for (Send send : sends) {
            if (send.port().name().equals(port.name())) {
                return send;
            }
        }
        return null;
    }

    private static @Nullable Sent fixed(Port port, List<Send> sends, Automaton automaton) {
        Send send = send(port, sends);
        if (send == null) {
            return automaton.omitted() == Automaton.Omitted.SILENT ? Sent.SILENCE : anything(port);
        }
        return send.emission()
                .match(
                        messages -> constants(messages, port),
                        () -> Sent.SILENCE,
                        Sent.AnyMessage::new);
    }

    private static @Nullable Sent constants(Automaton.Messages messages, Port port) {
        List<Value> values = new ArrayList<>();
        for (Expression value : messages.values()) {
            if (!(value instanceof Expression.Constant constant)
                    || port.type() instanceof Type.IntegerType) {
                return null;
            }
            values.add(constant.value());
        }
        return new Sent.Messages(values);
    }

    private static Emission emission(Port port, List<Send> sends, Scope scope) {
        List<Term> values =
                Objects.requireNonNull(send(port, sends)).emission().values().stream()
                        .map(v -> Evaluation.compile(v, scope))
                        .toList();
        return new Emission(port.name(), port.type(), values);
    }

    @SuppressWarnings("NullAway") // who may be carried out has defined values
    public Output output(Value[] ports, Value[] variables) {
        if (constantOutput != null) {
            return constantOutput;
        }
        List<Sent> sent = new ArrayList<>(fixed);
        for (int i = 0; i < sent.size(); i++) {
            Emission emission = computed.get(i);
            if (emission != null) {
                List<Value> values = new ArrayList<>(emission.values.size());
                for (Term term : emission.values) {
                    Value value = term.evaluate(ports, variables);
                    values.add(inRange(emission.name, emission.type, value));
                }
                sent.set(i, new Sent.Messages(values));
            }
        }
        return new Output(sent);
    }

    /** All right-hand sides are evaluated before any variable changes. */
    @SuppressWarnings("NullAway") // who may be carried out has defined values
    public Value[] variables(Value[] ports, Value[] before) {
        if (updates.isEmpty()) {
            return before;
        }
        Value[] after = before.clone();
        for (Update update : updates) {
            Value value = update.value.evaluate(ports, before);
            after[update.slot] = inRange(update.name, update.type, value);
        }
        return after;
    }

    /**
     * The value itself.
     *
     * @throws Fault if it lies outside of what it is for
     */
    public static Value inRange(String name, Type type, Value value) {
        if (type instanceof Type.IntegerType integer && integer.ranged()) {
            long number = value.whole();
            if (number < integer.low() || number > integer.high()) {
                throw Fault.outsideRange(name, value, type.name());
            }
        }
        return value;
    }
}

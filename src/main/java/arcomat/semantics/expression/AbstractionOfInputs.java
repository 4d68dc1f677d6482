package arcomat.semantics.expression;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.Compared;
import arcomat.semantics.value.InputAbstraction.Copied;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.InputAbstraction.Unseen;
import arcomat.semantics.value.InputAbstraction.Whole;
import arcomat.semantics.value.TooManyWays;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;

/**
 * Reads off the transitions out of one state what they look at. Comparisons of a port with a value
 * that no port has a say in divide its messages; anything else takes the whole message.
 */
public final class AbstractionOfInputs extends ConditionWalk {

    /**
     * What is done with a port.
     *
     * @param look how the port is looked at with certain values of the variables
     * @param fixed whether that is the same in all configurations
     */
    private record Probe(Port port, Function<Value[], PortAbstraction> look, boolean fixed) {}

    private final Scope scope;
    private final int ports;
    private final Value[] nothing;
    private final List<Probe> probes = new ArrayList<>();
    private final List<Integer> seen = new ArrayList<>();
    private @Nullable InputAbstraction constant;

    /** Whether statements look at ports, on ways of which there are too many to be looked at. */
    private boolean open;

    public AbstractionOfInputs(Component component, Scope scope) {
        this.scope = scope;
        this.ports = component.inputs().size();
        this.nothing = new Value[ports];
    }

    /** Adds what a transition looks at. */
    public void add(Expression enabledWhen, Automaton.Transition transition) {
        open |= transition.isWhole();
        condition(enabledWhen);
        for (Automaton.Send send : transition.sends()) {
            send.emission().values().forEach(this::copy);
        }
        transition.assignments().forEach(assignment -> copy(assignment.value()));
    }

    /**
     * What is looked at with certain values of the variables.
     *
     * @throws TooManyWays where statements look at more than can be said
     */
    public InputAbstraction with(Value[] variables) {
        if (open) {
            throw new TooManyWays();
        }
        if (constant != null) {
            return constant;
        }
        PortAbstraction[] looks = new PortAbstraction[ports];
        Arrays.fill(looks, new Unseen());
        for (int port : seen) {
            looks[port] = new Compared(List.of(), false);
        }
        boolean fixed = true;
        for (Probe probe : probes) {
            fixed &= probe.fixed;
            int port = scope.port(probe.port);
            looks[port] = looks[port].and(probe.look.apply(variables));
        }
        InputAbstraction abstraction = new InputAbstraction(List.of(looks));
        if (fixed || variables.length == 0) {
            constant = abstraction;
        }
        return abstraction;
    }

    /** A value that reads no port is defined. */
    private PortAbstraction compared(Type type, Term term, boolean ordered, Value[] variables) {
        try {
            Value value = Objects.requireNonNull(term.evaluate(nothing, variables));
            return new Compared(Comparand.in(type, value), ordered);
        } catch (Fault divisionByZero) {
            return new Whole();
        }
    }

    @Override
    void isIn(Expression.IsIn isIn) {
        Optional<Port> port = Comparand.port(isIn.element());
        if (port.isPresent()) {
            isIn.set().forEach(value -> compare(port.get(), value, false));
        } else {
            value(isIn);
        }
    }

    @Override
    void comparison(Expression.Binary binary, boolean ordered) {
        Optional<Port> left = Comparand.port(binary.left());
        Optional<Port> right = Comparand.port(binary.right());
        if (left.isPresent() && left.equals(right)) {
            withItself(left.get());
        } else if (left.isPresent()) {
            compare(left.get(), binary.right(), ordered);
        } else if (right.isPresent()) {
            compare(right.get(), binary.left(), ordered);
        } else {
            value(binary);
        }
    }

    /**
     * That tells nothing of a message, but whether it is a number: only NaN differs from itself.
     */
    private void withItself(Port port) {
        seen.add(scope.port(port));
        if (port.type() instanceof Type.RealType) {
            PortAbstraction withZero = new Compared(List.of(new Value.RealValue(0)), true);
            probes.add(new Probe(port, variables -> withZero, true));
        }
    }

    @Override
    void matches(Expression.PortMatches matches) {
        seen.add(scope.port(matches.port()));
        matches.operands().forEach(value -> compare(matches.port(), value, false));
    }

    private void compare(Port port, Expression value, boolean ordered) {
        List<Port> others = value.ports();
        if (others.isEmpty()) {
            Term term = Evaluation.compile(value, scope);
            Type type = port.type();
            probes.add(
                    new Probe(
                            port,
                            variables -> compared(type, term, ordered, variables),
                            isFixed(value)));
        } else if (ordered) {
            whole(port);
            others.forEach(this::whole);
        } else {
            copy(port);
            copy(value);
        }
    }

    /** Each message may give another value, but not more than copies of messages. */
    private void copy(Expression e) {
        if (e instanceof Expression.PortRead read) {
            copy(read.port());
        } else if (Comparand.isCopy(e)) {
            e.operands().forEach(this::copy);
        } else if (e instanceof Expression.Conditional choice && !isTruth(choice)) {
            condition(choice.condition());
            copy(choice.then());
            copy(choice.otherwise());
        } else if (isTruth(e)) {
            condition(e);
        } else {
            value(e);
        }
    }

    private void copy(Port port) {
        probes.add(new Probe(port, variables -> new Copied(), true));
    }

    @Override
    void value(Expression e) {
        if (e instanceof Expression.Conditional choice) {
            condition(choice.condition());
            value(choice.then());
            value(choice.otherwise());
        } else if (isCalculated(e)) {
            e.operands().forEach(this::value);
        } else {
            e.ports().forEach(this::whole);
        }
    }

    /** Whether a value is a number that depends on its operands, and on nothing else. */
    private static boolean isCalculated(Expression e) {
        return e.type().isNumber()
                && !e.operands().isEmpty()
                && !(e instanceof Expression.AttributeRead);
    }

    private void whole(Port port) {
        probes.add(new Probe(port, variables -> new Whole(), true));
    }

    /** Whether a value is the same in all configurations. */
    private boolean isFixed(Expression value) {
        return !value.contains(scope::isVariable);
    }

    private static boolean isTruth(Expression e) {
        return e.type() instanceof Type.BooleanType;
    }
}

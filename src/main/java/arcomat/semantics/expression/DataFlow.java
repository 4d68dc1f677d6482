package arcomat.semantics.expression;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.value.TooManyWays;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;

/** Tells where the data of one automaton flow, and what it does with them. */
public final class DataFlow extends ConditionWalk {
    private final DataSorts sorts;
    private final Scope scope;
    private final Map<String, Integer> ports;
    private final int[] variables;

    /**
     * What an expression may give.
     *
     * @param places whose data it may pass on
     * @param constants that it may be instead
     * @param calculated whether it may be something else
     */
    private record Data(List<Integer> places, List<Value> constants, boolean calculated) {
        static final Data CALCULATED = new Data(List.of(), List.of(), true);

        static Data of(int place) {
            return new Data(List.of(place), List.of(), false);
        }

        Data or(Data other) {
            List<Integer> both = new ArrayList<>(places);
            both.addAll(other.places);
            List<Value> fixed = new ArrayList<>(constants);
            fixed.addAll(other.constants);
            return new Data(both, fixed, calculated || other.calculated);
        }
    }

    /**
     * @param ports the places of the component's ports
     * @param variables the places of the automaton's variables
     */
    public DataFlow(DataSorts sorts, Scope scope, Map<String, Integer> ports, int[] variables) {
        this.sorts = sorts;
        this.scope = scope;
        this.ports = ports;
        this.variables = variables;
    }

    /** Tells of a whole automaton; of its variables' first values, too. */
    public void tell(Automaton automaton) {
        for (int i = 0; i < variables.length; i++) {
            pass(automaton.variables().get(i).initial(), variables[i]);
        }
        for (Automaton.Initial initial : automaton.initials()) {
            effect(initial.sends(), initial.assignments());
        }
        for (Automaton.Transition transition : automaton.transitions()) {
            if (transition.isWhole()) {
                throw new TooManyWays();
            }
            for (Automaton.Match match : transition.matches()) {
                pattern(match.port(), match.pattern());
            }
            transition.guard().ifPresent(this::condition);
            effect(transition.sends(), transition.assignments());
        }
    }

    private void effect(List<Automaton.Send> sends, List<Automaton.Assignment> assignments) {
        for (Automaton.Send send : sends) {
            send.emission().values().forEach(value -> pass(value, place(send.port())));
        }
        for (Automaton.Assignment assignment : assignments) {
            pass(assignment.value(), variables[scope.variable(assignment.variable())]);
        }
    }

    private int place(Port port) {
        return Objects.requireNonNull(ports.get(port.name()));
    }

    /** The value of an expression gets to a place, or is compared with what is there. */
    private void pass(Expression value, int place) {
        meet(data(value), Data.of(place));
    }

    private void meet(Data one, Data other) {
        Data both = one.or(other);
        for (int place : both.places) {
            sorts.join(both.places.get(0), place);
        }
        if (!both.places.isEmpty()) {
            int place = both.places.get(0);
            both.constants.forEach(constant -> sorts.mention(place, constant));
            if (both.calculated) {
                sorts.calculate(place);
            }
        }
    }

    private Data data(Expression e) {
        if (isClosed(e)) {
            return constant(e)
                    .map(value -> new Data(List.of(), List.of(value), false))
                    .orElse(Data.CALCULATED);
        }
        OptionalInt read = place(e);
        if (read.isPresent()) {
            return Data.of(read.getAsInt());
        }
        if (e instanceof Expression.Conditional choice) {
            condition(choice.condition());
            return data(choice.then()).or(data(choice.otherwise()));
        }
        if (Comparand.isCopy(e)) {
            return data(e.operands().get(0));
        }
        if (e.type() instanceof Type.BooleanType && !(e instanceof Expression.AttributeRead)) {
            condition(e);
        } else {
            calculate(e);
        }
        return Data.CALCULATED;
    }

    /** The place that an expression reads as it is. */
    private OptionalInt place(Expression e) {
        if (e instanceof Expression.PortRead read) {
            return OptionalInt.of(place(read.port()));
        }
        return e instanceof Expression.VariableRead read
                ? OptionalInt.of(variables[scope.variable(read.variable())])
                : OptionalInt.empty();
    }

    private void calculate(Expression e) {
        for (Expression operand : e.operands()) {
            data(operand).places.forEach(sorts::calculate);
        }
    }

    @Override
    void matches(Expression.PortMatches matches) {
        pattern(matches.port(), matches.pattern());
    }

    @Override
    void isIn(Expression.IsIn isIn) {
        isIn.set().forEach(value -> compare(isIn.element(), value, false));
    }

    @Override
    void comparison(Expression.Binary binary, boolean ordered) {
        compare(binary.left(), binary.right(), ordered);
    }

    @Override
    void value(Expression e) {
        if (e instanceof Expression.Binary binary
                && binary.operator() == Expression.BinaryOperator.EQUIVALENT) {
            comparison(binary, false);
        } else if (e instanceof Expression.Binary) {
            calculate(e);
        } else {
            data(e).places.forEach(sorts::calculate);
        }
    }

    private void pattern(Port port, Automaton.Pattern pattern) {
        Expression read = new Expression.PortRead(port, port.span());
        pattern.values().forEach(value -> compare(read, value, false));
    }

    private void compare(Expression left, Expression right, boolean ordered) {
        if (isClosed(right)) {
            with(left, right, ordered);
        } else if (isClosed(left)) {
            with(right, left, ordered);
        } else if (ordered) {
            data(left).places.forEach(sorts::calculate);
            data(right).places.forEach(sorts::calculate);
        } else {
            meet(data(left), data(right));
        }
    }

    /** What a comparison with a constant asks, in terms of the data themselves. */
    private void with(Expression e, Expression closed, boolean ordered) {
        Data data = data(Comparand.exact(e));
        Optional<Value> value = constant(closed);
        for (int place : data.places) {
            if (value.isEmpty()) {
                sorts.calculate(place);
                continue;
            }
            for (Type type : List.copyOf(sorts.types(place))) {
                for (Value divided : Comparand.in(type, value.get())) {
                    if (ordered) {
                        sorts.order(place, divided);
                    } else {
                        sorts.mention(place, divided);
                    }
                }
            }
        }
    }

    /** Whether an expression has the same value always. */
    private boolean isClosed(Expression e) {
        return !e.contains(
                each ->
                        each instanceof Expression.PortRead
                                || each instanceof Expression.PortMatches
                                || scope.isVariable(each));
    }

    /** Empty where it goes wrong. */
    private Optional<Value> constant(Expression closed) {
        try {
            return Optional.of(scope.constant(closed));
        } catch (Fault divisionByZero) {
            return Optional.empty();
        }
    }
}

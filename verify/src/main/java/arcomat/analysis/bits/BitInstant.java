package arcomat.analysis.bits;

import arcomat.analysis.reachability.Instant;
import arcomat.analysis.reachability.Reachability;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.expression.Scope;
import arcomat.semantics.value.GivenUp;

import org.jspecify.annotations.Nullable;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.IntPredicate;
import java.util.function.IntSupplier;
import java.util.stream.IntStream;

/** Where an automaton is at one point of a run, in bits. What has no circuit may be anything. */
final class BitInstant implements Instant<int[]> {
    private final Subject subject;
    private final Circuit circuit;
    private final ValueBits values;
    private final BitExpressions expressions;
    private final IntPredicate isTrue;
    private final Runnable inexact;
    private final int[] states;
    private final Map<String, int[]> variables = new HashMap<>();
    private final Map<String, Integer> present = new HashMap<>();

    /**
     * @param states one literal per state, of which one is true
     * @param isTrue after the answer yes: of a literal, in the example
     * @param inexact told where something may be anything
     */
    BitInstant(
            Subject subject,
            ValueBits values,
            int[] states,
            IntPredicate isTrue,
            Runnable inexact) {
        this.subject = subject;
        this.circuit = values.circuit();
        this.values = values;
        this.expressions = new BitExpressions(values, new Reads());
        this.isTrue = isTrue;
        this.inexact = inexact;
        this.states = states;
        for (Variable variable : subject.automaton().variables()) {
            variables.put(variable.name(), values.any(variable.type()));
        }
        for (Port port : subject.component().inputs()) {
            boolean always = subject.isAlwaysThere(port);
            present.put(port.name(), always ? circuit.of(true) : circuit.input(1)[0]);
        }
    }

    /** Whether what has been said so far is exact. */
    boolean isExact() {
        return expressions.unknown().all().isEmpty();
    }

    @Override
    public int[] isIn(int state) {
        return truth(states[state]);
    }

    private static int[] truth(int literal) {
        return new int[] {literal};
    }

    @Override
    public int[] has(Port port) {
        return truth(literal(port));
    }

    private int literal(Port port) {
        return Objects.requireNonNull(present.get(port.name()));
    }

    private final class Reads implements BitReads {
        @Override
        public int has(Port port) {
            return literal(port);
        }

        /** What is no variable of the automaton is a constant of the component. */
        @Override
        public int[] variable(Expression.VariableRead read) {
            int[] bits = variables.get(read.variable().name());
            return bits != null ? bits : value(read.variable().initial());
        }

        @Override
        public Value argument(Expression.ParameterRead read) {
            return Scope.ofParameters(subject.component().parameters(), subject.arguments())
                    .constant(read);
        }

        @Override
        public int[] instead(Expression e, GivenUp noBits) {
            inexact.run();
            return values.any(e.type());
        }
    }

    @Override
    public int[] value(Expression e) {
        return expressions.bits(e);
    }

    @Override
    public int[] areSame(Expression one, Expression other) {
        try {
            return truth(expressions.areSame(one, other));
        } catch (GivenUp noBits) {
            inexact.run();
            return circuit.input(1);
        }
    }

    @Override
    public int[] is(Variable variable, Value value) {
        return claim(() -> circuit.areEqual(bits(variable), values.of(value, variable.type())));
    }

    private int[] bits(Variable variable) {
        return Objects.requireNonNull(variables.get(variable.name()));
    }

    /** What cannot be said is not claimed. */
    private int[] claim(IntSupplier said) {
        try {
            return truth(said.getAsInt());
        } catch (GivenUp noBits) {
            inexact.run();
            return truth(circuit.of(true));
        }
    }

    @Override
    public int[] is(Variable variable, Expression value, Instant<int[]> there) {
        int[] bits = there.value(value);
        return claim(
                () -> {
                    BitExpressions.requireAlike(variable.type(), value);
                    int width = Math.max(bits.length, bits(variable).length);
                    return circuit.areEqual(
                            Circuit.resized(bits(variable), width), Circuit.resized(bits, width));
                });
    }

    @Override
    public int[] isWellTyped() {
        IntStream remembered =
                subject.automaton().variables().stream()
                        .mapToInt(each -> isOf(bits(each), each.type()));
        IntStream read =
                subject.component().inputs().stream()
                        .mapToInt(each -> isOf(message(each), each.type()));
        return truth(circuit.and(IntStream.concat(remembered, read)));
    }

    private int isOf(int[] bits, Type type) {
        return claim(() -> values.isOf(bits, type))[0];
    }

    private int[] message(Port port) {
        return value(new Expression.PortRead(port, port.span()));
    }

    /** Literals that make messages small numbers, which are easier to read. */
    IntStream areBelow(int width) {
        return subject.component().inputs().stream()
                .flatMapToInt(port -> values.areBelow(message(port), port.type(), width));
    }

    @Override
    public Reachability.Place place() {
        int state = 0;
        while (!isTrue.test(states[state])) {
            state++;
        }
        return new Reachability.Place(
                state,
                subject.automaton().variables().stream()
                        .map(each -> decoded(bits(each), each.type()))
                        .toList());
    }

    private Value decoded(int[] bits, Type type) {
        try {
            return values.meaning(bits, type, isTrue);
        } catch (GivenUp noBits) {
            return type.first();
        }
    }

    @Override
    public @Nullable Value[] letter() {
        return subject.component().inputs().stream()
                .map(
                        port ->
                                isTrue.test(literal(port))
                                        ? decoded(message(port), port.type())
                                        : null)
                .toArray(Value[]::new);
    }
}

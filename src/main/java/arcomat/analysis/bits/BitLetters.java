package arcomat.analysis.bits;

import arcomat.analysis.symbolic.CheckedSolver;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.value.GivenUp;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Letters that make conditions true, where all is numbers, truth values and constants. Says that
 * there is none only where that is proved and the proof has been checked. Conditions are literals:
 * negative where the opposite is meant. All gives up where something else comes in.
 */
public final class BitLetters {
    /** Assignments for one letter: seconds. A solver that needs more hardly finds an end. */
    private static final long MOST_WORK = 10_000_000;

    /** Of these, to look for numbers that are easy to read. */
    private static final long WORK_FOR_SHORT = MOST_WORK / 20;

    private final List<Port> ports;
    private final BooleanSupplier stop;
    private final CheckedSolver solver = new CheckedSolver(this::insist);
    private final Circuit circuit = new Circuit(solver.clauses());
    private final BitExpressions expressions = new BitExpressions(circuit);
    private long workBefore;

    /**
     * @param ports each with a message
     * @param stop asked now and then, whether to give up
     */
    public BitLetters(List<Port> ports, BooleanSupplier stop) {
        this.ports = List.copyOf(ports);
        this.stop = stop;
        for (Port port : ports) {
            claim(expressions.isOf(expressions.message(port), port.type()));
        }
    }

    /** Whether values of a type have bits. */
    public static boolean areFor(Type type) {
        try {
            return BitCodes.of(type).width() > 0;
        } catch (GivenUp none) {
            return false;
        }
    }

    private void insist() {
        if (solver.work() - workBefore > MOST_WORK || stop.getAsBoolean()) {
            throw new GivenUp("too much to conclude about bits");
        }
    }

    /** That a condition is true. */
    public int truth(Expression condition) {
        return expressions.truth(condition);
    }

    /** That two expressions give the same message. */
    public int areSame(Expression one, Expression other) {
        return expressions.areSame(one, other);
    }

    /** That an expression has a value. */
    public int is(Expression e, Value value) {
        int[] bits = expressions.bits(e);
        return circuit.areEqual(bits, expressions.value(value, e.type()));
    }

    /** That all of some conditions are true. */
    public int and(List<Integer> conditions) {
        int all = circuit.of(true);
        for (int condition : conditions) {
            all = circuit.and(all, condition);
        }
        return all;
    }

    /** Only letters matter of which this is true. */
    public void claim(int condition) {
        solver.clauses().add(condition);
    }

    /**
     * A letter, by port; empty where there is none. Small numbers are preferred, which are easier
     * to read.
     *
     * @throws GivenUp where that takes too long
     */
    public Optional<Value[]> find() {
        workBefore = solver.work();
        return solver.finds(WORK_FOR_SHORT, areBelow(7))
                        || solver.finds(WORK_FOR_SHORT, areBelow(15))
                        || solver.solve()
                ? Optional.of(ports.stream().map(this::message).toArray(Value[]::new))
                : Optional.empty();
    }

    /** That all messages are numbers of so many bits. */
    private int[] areBelow(int width) {
        return ports.stream().flatMapToInt(port -> areBelow(port, width)).toArray();
    }

    private IntStream areBelow(Port port, int width) {
        int[] bits = expressions.message(port);
        return port.type() instanceof Type.RealType real
                ? IntStream.of(expressions.isShort(bits, real, width))
                : Arrays.stream(bits).skip(width).map(bit -> -bit);
    }

    private Value message(Port port) {
        int[] bits = expressions.message(port);
        long number = 0;
        for (int i = 0; i < bits.length; i++) {
            if (solver.isTrue(bits[i])) {
                number |= 1L << i;
            }
        }
        return BitCodes.of(port.type())
                .meaning()
                .apply(bits.length == Integer.SIZE ? (int) number : number);
    }
}

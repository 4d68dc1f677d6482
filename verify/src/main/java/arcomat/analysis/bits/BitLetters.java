package arcomat.analysis.bits;

import arcomat.analysis.bits.UnknownResults.Result;
import arcomat.analysis.symbolic.CheckedSolver;
import arcomat.model.Expression;
import arcomat.model.ExpressionText;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Scope;
import arcomat.semantics.value.GivenUp;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * Letters that make conditions true, where all is numbers, truth values, constants, texts, and
 * objects with such attributes. Says that there is none only where that is proved and the proof has
 * been checked. Conditions are literals: negative where the opposite is meant. All gives up where
 * something else comes in.
 */
public final class BitLetters {
    /** Assignments for one letter: seconds. A solver that needs more hardly finds an end. */
    private static final long MOST_WORK = 10_000_000;

    /** Of these, to look for numbers that are easy to read. */
    private static final long WORK_FOR_SHORT = MOST_WORK / 20;

    private final List<Port> ports;
    private final int lessons;
    private final BooleanSupplier stop;
    private final CheckedSolver solver = new CheckedSolver(this::insist);
    private final Circuit circuit = new Circuit(solver.clauses());
    private final ValueBits values = new ValueBits(circuit, new TextCodes());
    private final BitExpressions expressions = new BitExpressions(values, port -> circuit.of(true));
    private long workBefore;

    /**
     * @param ports each with a message
     * @param stop asked now and then, whether to give up
     */
    public BitLetters(List<Port> ports, BooleanSupplier stop) {
        this(ports, Map.of(), 0, stop);
    }

    /**
     * As above.
     *
     * @param same ports that carry the same message as another one of their type, which is no such
     *     port: what is calculated from both in the same way is the same without a question
     * @param lessons how often, for one letter, it is found out what an operation gives that has no
     *     circuit
     */
    public BitLetters(List<Port> ports, Map<Port, Port> same, int lessons, BooleanSupplier stop) {
        this.ports = List.copyOf(ports);
        this.lessons = lessons;
        this.stop = stop;
        same.forEach((port, other) -> expressions.join(other, port));
        for (Port port : ports) {
            claim(values.isOf(expressions.message(port), port.type()));
        }
    }

    /** Whether all that an expression is made of has a circuit, as far as operations tell. */
    public static boolean areExact(Expression e) {
        return !e.contains(
                part -> part instanceof Expression.Binary binary && UnknownResults.isOf(binary));
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
        return circuit.areEqual(bits, values.of(value, e.type()));
    }

    /** That all of some conditions are true. */
    public int and(List<Integer> conditions) {
        return circuit.and(conditions.stream().mapToInt(condition -> condition));
    }

    /** Only letters matter of which this is true. */
    public void claim(int condition) {
        solver.clauses().add(condition);
    }

    /** How much has been done so far, in assignments and gates: equal on every machine. */
    public long work() {
        return solver.work() + circuit.gates();
    }

    /**
     * A letter, by port; empty where there is none. Small numbers are preferred, which are easier
     * to read.
     *
     * @throws GivenUp where that takes too long
     */
    public Optional<Value[]> find() {
        workBefore = solver.work();
        Optional<Value[]> found = possible();
        for (int lesson = 0; found.isPresent(); lesson++) {
            Optional<Result> wrong = wrong(found.get());
            if (wrong.isEmpty()) {
                return found;
            }
            if (lesson == lessons) {
                throw undecided(wrong.get().operation());
            }
            found = learnt(wrong.get().operation(), found.get());
        }
        return found;
    }

    /** With what an operation gives, first of all the same letter: it may do all the same. */
    private Optional<Value[]> learnt(Expression.Binary operation, Value[] letter) {
        int[] same =
                ports.stream()
                        .flatMapToInt(port -> Arrays.stream(expressions.message(port)))
                        .map(bit -> solver.isTrue(bit) ? bit : -bit)
                        .toArray();
        learn(operation, letter);
        return solver.finds(WORK_FOR_SHORT, same) ? Optional.of(letter) : possible();
    }

    /** A letter, as far as circuits tell. */
    private Optional<Value[]> possible() {
        return solver.finds(WORK_FOR_SHORT, areBelow(7))
                        || solver.finds(WORK_FOR_SHORT, areBelow(15))
                        || solver.solve()
                ? Optional.of(ports.stream().map(this::message).toArray(Value[]::new))
                : Optional.empty();
    }

    private static GivenUp undecided(Expression operation) {
        return new GivenUp(
                "what '%s' gives has no circuit".formatted(ExpressionText.of(operation)));
    }

    /** The first operation that gives something else than what was taken for its result. */
    private Optional<Result> wrong(Value[] letter) {
        return expressions.unknown().all().stream()
                .filter(each -> !isRight(each, letter))
                .findFirst();
    }

    private boolean isRight(Result result, Value[] letter) {
        Expression operation = result.operation();
        try {
            return value(operation, letter).equals(value(result.bits(), operation.type()));
        } catch (Fault divisionByZero) {
            return true; // nobody asks for what it gives
        }
    }

    /** That an operation gives what it gives, wherever it is done with these operands. */
    private void learn(Expression.Binary operation, Value[] letter) {
        int left = is(operation.left(), value(operation.left(), letter));
        int right = is(operation.right(), value(operation.right(), letter));
        int result = is(operation, value(operation, letter));
        claim(-and(List.of(left, right, -result)));
    }

    private Value value(Expression e, Value[] letter) {
        return Objects.requireNonNull(Scope.ofPorts(ports).value(e, letter));
    }

    /** That all messages are numbers of so many bits. */
    private int[] areBelow(int width) {
        return ports.stream()
                .flatMapToInt(
                        port -> values.areBelow(expressions.message(port), port.type(), width))
                .toArray();
    }

    private Value message(Port port) {
        return value(expressions.message(port), port.type());
    }

    private Value value(int[] bits, Type type) {
        return values.meaning(bits, type, solver::isTrue);
    }
}

package arcomat.analysis.bits;

import arcomat.analysis.reachability.Instant;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.symbolic.CheckedSolver;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Runs of an automaton in bits: products of variables and numbers of floating point are exact, too.
 * That nothing is possible is believed only where the proof of it has been checked.
 */
public final class BitLogic implements Logic<int[]> {
    public static final Kind<int[]> KIND = BitLogic::new;

    /** Assignments for one question: a second or so. */
    private static final long MOST_WORK = 1_000_000;

    /** For all of them. */
    private static final long ALL_WORK = 10 * MOST_WORK;

    /** Of these, before it is asked whether to stop. */
    private static final long PORTION = 50_000;

    /** Longer runs are not looked for; more would take too much memory. */
    private static final int MOST_CLAUSES = 1_000_000;

    private final Subject subject;
    private final BooleanSupplier stop;
    private final CheckedSolver solver = new CheckedSolver(() -> {});
    private final TextCodes texts = new TextCodes();
    private final Circuit circuit = new Circuit(solver.clauses());
    private final List<BitInstant> instants = new ArrayList<>();
    private boolean exact = true;

    private BitLogic(Subject subject, BooleanSupplier stop) {
        this.subject = subject;
        this.stop = stop;
    }

    @Override
    public int[] of(boolean truth) {
        return new int[] {circuit.of(truth)};
    }

    @Override
    public int[] and(List<int[]> all) {
        return new int[] {circuit.and(all.stream().mapToInt(each -> each[0]))};
    }

    @Override
    public int[] or(List<int[]> any) {
        return not(and(any.stream().map(this::not).toList()));
    }

    @Override
    public int[] not(int[] condition) {
        return new int[] {-condition[0]};
    }

    @Override
    public void claim(int[] condition) {
        solver.clauses().add(condition[0]);
    }

    @Override
    public Answer assuming(List<int[]> conditions) {
        return answer(literals(conditions));
    }

    private static int[] literals(List<int[]> conditions) {
        return conditions.stream().mapToInt(each -> each[0]).toArray();
    }

    @Override
    public Answer assuming(List<int[]> conditions, Runnable ifYes) {
        int[] assumed = literals(conditions);
        Answer answer = answer(assumed);
        if (answer == Answer.YES && !areSmall(assumed)) {
            answer = answer(assumed);
        }
        if (answer == Answer.YES) {
            ifYes.run();
        }
        return answer;
    }

    /** Small messages are easier to read, and the last one may have to be a large one. */
    private boolean areSmall(int[] assumed) {
        return areSmall(instants, 7, assumed)
                || areSmall(instants, 15, assumed)
                || areSmall(instants.subList(0, instants.size() - 1), 15, assumed);
    }

    /** Whether messages may be numbers of so many bits at some instants. */
    private boolean areSmall(List<BitInstant> some, int width, int[] assumed) {
        IntStream below = some.stream().flatMapToInt(each -> each.areBelow(width));
        return solver.finds(PORTION / 5, IntStream.concat(IntStream.of(assumed), below).toArray());
    }

    private Answer answer(int[] assumed) {
        long most = Math.min(ALL_WORK, solver.work() + MOST_WORK);
        boolean small = solver.clauses().size() < MOST_CLAUSES;
        while (small && solver.work() < most && !stop.getAsBoolean()) {
            Optional<Boolean> answer = solver.answer(PORTION, assumed);
            if (answer.isPresent()) {
                return answer.get() ? Answer.YES : Answer.NO;
            }
        }
        return Answer.UNKNOWN;
    }

    @Override
    public Instant<int[]> instant() {
        int[] states = solver.clauses().oneOf(subject.automaton().states().size());
        BitInstant next =
                new BitInstant(
                        subject,
                        new ValueBits(new Circuit(solver.clauses()), texts),
                        states,
                        solver::isTrue,
                        () -> exact = false);
        instants.add(next);
        return next;
    }

    @Override
    public boolean isExact() {
        return exact && instants.stream().allMatch(BitInstant::isExact);
    }
}

package arcomat.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Two groups of processes make rows in turn, for some seconds each, while the other group stands
 * still: what the machine does beside it, and how warm it is, meets both. What counts is the median
 * of the rounds, each a pair; and only rounds in which nobody else took much of the processors.
 */
final class Contest {
    private static final Duration TURN = Duration.ofSeconds(4);
    private static final Duration SETTLING = Duration.ofMillis(500);
    private static final int ROUNDS = 9;

    /** So many rounds have to be quiet ones, else nothing is said by the clock. */
    private static final int ENOUGH = 5;

    /** What others may take of all processors in a quiet turn. */
    private static final double QUIET = 0.05;

    private final ToolProcesses tool;
    private final List<Round> rounds = new ArrayList<>();

    Contest(ToolProcesses tool) {
        this.tool = tool;
    }

    /**
     * A group.
     *
     * @param out folder of its campaign, in which rows are counted
     */
    record Group(String out, List<Process> processes) {}

    /**
     * What a group did in its turn.
     *
     * @param rowsPerSecond by the clock
     * @param rowsPerProcessorSecond by the time of processors that it took itself
     * @param others share of all processors that others took
     */
    private record Turn(double rowsPerSecond, double rowsPerProcessorSecond, double others) {}

    private record Round(Turn first, Turn second) {
        boolean isQuiet() {
            return first.others < QUIET && second.others < QUIET;
        }

        double byClock() {
            return second.rowsPerSecond / first.rowsPerSecond;
        }

        double byProcessors() {
            return second.rowsPerProcessorSecond / first.rowsPerProcessorSecond;
        }
    }

    /** Rounds of two groups that are warm and stand still; they do so again afterwards. */
    void hold(Group first, Group second) throws Exception {
        for (int i = 0; i < ROUNDS && isOpen(); i++) {
            // Who begins takes turns as well.
            Turn before = turn(i % 2 == 0 ? first : second);
            Turn after = turn(i % 2 == 0 ? second : first);
            rounds.add(i % 2 == 0 ? new Round(before, after) : new Round(after, before));
        }
    }

    /** Whether more rounds may still decide whether it is judged. */
    private boolean isOpen() {
        long loud = rounds.size() - quiet();
        return !isJudged() && loud <= ROUNDS - ENOUGH;
    }

    private long quiet() {
        return rounds.stream().filter(Round::isQuiet).count();
    }

    private Turn turn(Group group) throws Exception {
        ToolProcesses.signal("CONT", group.processes());
        Thread.sleep(SETTLING.toMillis());
        long begun = System.nanoTime();
        long busy = busyTicks();
        long rows = tool.rows(group.out());
        Duration own = ToolProcesses.processorTime(group.processes());
        Thread.sleep(TURN.toMillis());
        double seconds = (System.nanoTime() - begun) / 1e9;
        double made = tool.rows(group.out()) - rows;
        double used = seconds(ToolProcesses.processorTime(group.processes()).minus(own));
        double all = (busyTicks() - busy) / 100.0;
        ToolProcesses.signal("STOP", group.processes());
        double others = (all - used) / (seconds * Runtime.getRuntime().availableProcessors());
        return new Turn(made / seconds, made / used, others);
    }

    private static double seconds(Duration duration) {
        return duration.toNanos() / 1e9;
    }

    /** Whether it can be told how busy the processors are. */
    static boolean isPossible() {
        return Files.isReadable(Path.of("/proc/stat"));
    }

    /** Hundredths of seconds in which processors worked, or were taken by other machines. */
    private static long busyTicks() throws IOException {
        String all = Files.readAllLines(Path.of("/proc/stat")).get(0);
        long[] ticks = Arrays.stream(all.split(" +")).skip(1).mapToLong(Long::parseLong).toArray();
        // user, nice, system, idle, waiting for disks, interrupts (two), stolen
        return ticks[0] + ticks[1] + ticks[2] + ticks[5] + ticks[6] + ticks[7];
    }

    /** How many rows the second group makes for one of the first, by the clock. */
    double byClock() {
        return median(rounds.stream().filter(Round::isQuiet).mapToDouble(Round::byClock).toArray());
    }

    /** The same by the time of processors, whatever others did. */
    double byProcessors() {
        return median(rounds.stream().mapToDouble(Round::byProcessors).toArray());
    }

    private static double median(double[] numbers) {
        Arrays.sort(numbers);
        return numbers.length == 0 ? Double.NaN : numbers[numbers.length / 2];
    }

    /** Whether enough of it was quiet. */
    boolean isJudged() {
        return quiet() >= ENOUGH;
    }

    @Override
    public String toString() {
        double others =
                median(
                        rounds.stream()
                                .mapToDouble(
                                        each -> Math.max(each.first.others, each.second.others))
                                .toArray());
        return String.format(
                Locale.ROOT,
                "by the clock %.2f in %d quiet rounds of %d, by processors %.2f; others took %.0f"
                        + " %%",
                byClock(),
                quiet(),
                rounds.size(),
                byProcessors(),
                100 * others);
    }
}

package arcomat.cluster.spark;

import arcomat.campaign.Trial;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Trials that wait, and how they become tasks: knows nothing of Spark. A task costs Spark some
 * milliseconds of the driver, so it is to be long; but what is lost with an executor is made again,
 * and the last tasks are to end at about the same time, so it is not to be too long.
 */
final class Backlog {
    /** Trials of a task at most, where runs take no time. */
    static final int BATCH = 64;

    /** Trials of a task while nobody knows what a run takes. */
    static final int FIRST = 4;

    /** What a task is to take. */
    private static final long TASK_NANOS = TimeUnit.MILLISECONDS.toNanos(500);

    private final Deque<Trial> waiting = new ArrayDeque<>();
    private int tasks;
    private long made;
    private long nanoseconds;

    void submit(List<Trial> trials) {
        waiting.addAll(trials);
    }

    /**
     * The next tasks, for each core the one it makes and one that waits for it: given out together
     * once half of them are done, since each time costs the driver something, too.
     *
     * @param cores how many tasks are made at a time
     * @return none while there is enough to do
     */
    List<List<Trial>> next(int cores) {
        List<List<Trial>> next = new ArrayList<>();
        if (tasks > cores) {
            return next;
        }
        int size = size(cores);
        while (!waiting.isEmpty() && tasks < 3 * cores) {
            next.add(batch(size));
            tasks++;
        }
        return next;
    }

    private int size(int cores) {
        int share = (waiting.size() + 2 * cores - 1) / (2 * cores);
        return Math.max(1, Math.min(share, pace()));
    }

    /** Trials that take as long as a task is to take. */
    private int pace() {
        return made == 0
                ? FIRST
                : (int) Math.min(BATCH, TASK_NANOS / Math.max(1, nanoseconds / made));
    }

    private List<Trial> batch(int size) {
        List<Trial> batch = new ArrayList<>();
        while (batch.size() < size && !waiting.isEmpty()) {
            batch.add(waiting.removeFirst());
        }
        return batch;
    }

    /**
     * A task is done.
     *
     * @param trials how many runs it has made
     * @param took in nanoseconds, all of them together
     */
    void done(int trials, long took) {
        tasks--;
        made += trials;
        nanoseconds += took;
    }
}

package arcomat.cluster.hazelcast;

import arcomat.campaign.Trial;

import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;

/**
 * Which trials are wanted, and who has which: knows nothing of networks. A trial is wanted until it
 * is answered for the first time, whoever answers.
 *
 * <p>A worker that is gone may have been ended by a run that it made: then the next one will be,
 * and so forth. Which of the runs it was that it held nobody knows. So who was held by two workers
 * that are gone is given to a third one that has nothing else, and given up if that one goes as
 * well: whatever was beside the cause is made.
 */
final class Dispatch {
    /**
     * Trials that a worker holds for each of its threads. What it holds is made again if it dies.
     */
    private static final int HELD = 32;

    /** Trials of one message at most: a worker goes on with the next ones while answers travel. */
    private static final int BATCH = HELD / 2;

    /** A trial that so many workers went with is given up; the last of them had no other one. */
    static final int LOSSES = 3;

    private final Deque<Trial> waiting = new ArrayDeque<>();
    private final Deque<Trial> suspected = new ArrayDeque<>();
    private final Map<Long, Integer> losses = new HashMap<>();
    private final Map<Long, Trial> wanted = new HashMap<>();
    private final Map<UUID, Worker> workers = new LinkedHashMap<>();

    private static final class Worker {
        private final UUID name;
        private final int threads;
        private final Set<Long> held = new LinkedHashSet<>();
        private boolean full;

        Worker(UUID name, int threads) {
            this.name = name;
            this.threads = threads;
        }

        double load() {
            return (double) held.size() / threads;
        }

        int room() {
            return full ? 0 : HELD * threads - held.size();
        }

        /** It gets nothing else until it has answered. */
        Batch alone(Trial trial) {
            held.add(trial.number());
            full = true;
            return new Batch(name, List.of(trial));
        }

        void answered(long number) {
            held.remove(number);
            full &= !held.isEmpty();
        }
    }

    /**
     * What a worker held that is gone.
     *
     * @param again how many trials have to be made by others
     * @param givenUp those that nobody is to make any more
     */
    record Loss(int again, List<Trial> givenUp) {}

    /** Trials for a worker. */
    record Batch(UUID worker, List<Trial> trials) {}

    void submit(List<Trial> trials) {
        for (Trial each : trials) {
            wanted.put(each.number(), each);
            waiting.add(each);
        }
    }

    /**
     * @param threads how many trials it makes at a time, at least 1
     */
    void join(UUID worker, int threads) {
        workers.put(worker, new Worker(worker, threads));
    }

    /** What it held comes first now: later trials wait for it. */
    Loss leave(UUID worker) {
        Worker gone = workers.remove(worker);
        if (gone == null) {
            return new Loss(0, List.of());
        }
        List<Trial> lost = gone.held.stream().filter(wanted::containsKey).map(wanted::get).toList();
        List<Trial> givenUp = new ArrayList<>();
        for (int i = lost.size() - 1; i >= 0; i--) {
            Trial trial = lost.get(i);
            int times = losses.merge(trial.number(), 1, Integer::sum);
            if (times >= LOSSES) {
                forget(trial.number());
                givenUp.add(trial);
            } else {
                (times == LOSSES - 1 ? suspected : waiting).addFirst(trial);
            }
        }
        return new Loss(lost.size() - givenUp.size(), givenUp);
    }

    private @Nullable Trial forget(long number) {
        losses.remove(number);
        return wanted.remove(number);
    }

    /** Gives out what is waiting, as far as workers have room for it. */
    List<Batch> assign() {
        List<Batch> batches = new ArrayList<>(assignSuspected());
        // Several messages for each thread, so that all have an end at about the same time.
        int size = Math.max(1, Math.min(BATCH, waiting.size() / (2 * Math.max(1, threads()))));
        Optional<Worker> next = idlest();
        while (next.isPresent() && !waiting.isEmpty()) {
            batches.add(batch(next.get(), Math.min(size, next.get().room())));
            next = idlest();
        }
        batches.removeIf(batch -> batch.trials().isEmpty());
        return batches;
    }

    /**
     * Each to a worker that has nothing else. All others have to wait for early rows as well, so
     * there will be such a worker.
     */
    private List<Batch> assignSuspected() {
        List<Batch> batches = new ArrayList<>();
        for (Worker worker : workers.values()) {
            suspected.removeIf(trial -> !wanted.containsKey(trial.number()));
            if (worker.held.isEmpty() && !suspected.isEmpty()) {
                batches.add(worker.alone(suspected.removeFirst()));
            }
        }
        return batches;
    }

    private Optional<Worker> idlest() {
        return workers.values().stream()
                .filter(each -> each.room() > 0)
                .min(Comparator.comparingDouble(Worker::load));
    }

    private Batch batch(Worker worker, int size) {
        List<Trial> trials = new ArrayList<>();
        while (trials.size() < size && !waiting.isEmpty()) {
            Trial trial = waiting.removeFirst();
            // One that was given up for lost may have been answered since.
            if (wanted.containsKey(trial.number())) {
                worker.held.add(trial.number());
                trials.add(trial);
            }
        }
        return new Batch(worker.name, trials);
    }

    /**
     * An answer has come.
     *
     * @return the trial; none if nobody waits for it any more
     */
    Optional<Trial> answer(UUID from, long number) {
        Worker worker = workers.get(from);
        if (worker != null) {
            worker.answered(number);
        }
        return Optional.ofNullable(forget(number));
    }

    Set<UUID> workers() {
        return Set.copyOf(workers.keySet());
    }

    /** How many trials can be made at a time. */
    int threads() {
        return workers.values().stream().mapToInt(worker -> worker.threads).sum();
    }
}

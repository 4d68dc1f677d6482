package arcomat.editor.verdict;

import arcomat.editor.desk.Desk;
import arcomat.editor.desk.View;
import arcomat.pipeline.recheck.OpenModels;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/**
 * Asks about the files that somebody looks at, one after the other, the one looked at last before
 * the others. What an edit makes pointless is ended, and nothing is begun while somebody types. May
 * be called by any thread; nobody waits here.
 */
public final class Verdicts {
    private final ScheduledExecutorService thread;
    private final Duration quiet;
    private final Runnable answered;
    private final Set<Path> lookedAt = new LinkedHashSet<>();
    private final Map<Path, Known> known = new HashMap<>();

    /** By model roots. */
    private final Map<Path, OpenModels.Edition> newest = new HashMap<>();

    /** The newest last. */
    private final Map<Path, Inquiry> waiting = new LinkedHashMap<>();

    private Optional<Map.Entry<Path, Inquiry>> running = Optional.empty();
    private boolean isScheduled;
    private long lastChange;

    /**
     * @param thread one, with room for deep models
     * @param quiet how long nothing has to change before something is asked
     * @param answered told when more is known
     */
    public Verdicts(ScheduledExecutorService thread, Duration quiet, Runnable answered) {
        this.thread = thread;
        this.quiet = quiet;
        this.answered = answered;
    }

    /** What is known about a file that somebody looks at; what is not will be asked. */
    synchronized Optional<Known> look(View view) {
        Path file = view.place();
        lookedAt.add(file);
        Inquiry before = waiting.remove(file);
        want(file, view, before);
        return Optional.ofNullable(known.get(file));
    }

    /** Asks about a file again, whatever is known, before all others. */
    public synchronized void askAgain(View view) {
        known.remove(view.place());
        look(view);
        lastChange = System.nanoTime() - quiet.toNanos();
    }

    /** Something on the desk has changed. */
    public synchronized void changed(Desk desk) {
        lookedAt.removeIf(file -> desk.onScreen(file).isEmpty());
        known.keySet().retainAll(lookedAt);
        waiting.keySet().retainAll(lookedAt);
        running.filter(each -> !lookedAt.contains(each.getKey())).ifPresent(Verdicts::end);
        for (Path file : lookedAt) {
            desk.view(file).ifPresent(view -> want(file, view, waiting.get(file)));
        }
    }

    private void want(Path file, View view, @Nullable Inquiry before) {
        noteChange(view.models());
        if (isCurrent(file, view.models())) {
            waiting.remove(file);
            return;
        }
        if (running.isPresent() && running.get().getKey().equals(file)) {
            if (running.get().getValue().isAbout(view.models())) {
                return;
            }
            end(running.get());
        }
        boolean isSame = before != null && before.isAbout(view.models());
        waiting.put(file, isSame ? before : new Inquiry(view.models(), view.file().path()));
        schedule(quiet.toNanos());
    }

    private void noteChange(OpenModels models) {
        if (newest.put(models.root(), models.edition()) != models.edition()) {
            lastChange = System.nanoTime();
        }
    }

    private boolean isCurrent(Path file, OpenModels models) {
        Known there = known.get(file);
        return there != null && there.edition() == models.edition();
    }

    private static void end(Map.Entry<Path, Inquiry> inquiry) {
        inquiry.getValue().interruption().end();
    }

    private void schedule(long nanos) {
        if (!isScheduled && running.isEmpty() && !thread.isShutdown()) {
            isScheduled = true;
            var unused = thread.schedule(this::askNext, nanos, TimeUnit.NANOSECONDS);
        }
    }

    private void askNext() {
        begin().ifPresent(this::ask);
    }

    private void ask(Map.Entry<Path, Inquiry> next) {
        Optional<Known> answer = Optional.empty();
        try {
            answer = Optional.of(next.getValue().ask(last(next.getKey())));
        } catch (CancellationException notWanted) {
            // Whoever ended it knows what to ask instead.
        } finally {
            end(next, answer);
        }
        answered.run();
    }

    private synchronized Optional<Known> last(Path file) {
        return Optional.ofNullable(known.get(file));
    }

    /** The newest, once nobody types. */
    private synchronized Optional<Map.Entry<Path, Inquiry>> begin() {
        isScheduled = false;
        long left = lastChange + quiet.toNanos() - System.nanoTime();
        if (left > 0) {
            schedule(left);
            return Optional.empty();
        }
        running =
                waiting.entrySet().stream().reduce((older, newer) -> newer).map(Map.Entry::copyOf);
        running.ifPresent(each -> waiting.remove(each.getKey()));
        return running;
    }

    private synchronized void end(Map.Entry<Path, Inquiry> asked, Optional<Known> answer) {
        running = Optional.empty();
        if (lookedAt.contains(asked.getKey())) {
            answer.ifPresent(each -> known.put(asked.getKey(), each));
        }
        if (!waiting.isEmpty()) {
            schedule(0);
        }
    }
}

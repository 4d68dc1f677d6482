package arcomat.analysis.search.composition;

import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Sent;

import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.Objects;

/**
 * A run to completion as far as it has come, after one reaction more than the run before it: where
 * the parts are, what waits in their queues, and whose turn it is. Changed only while it is made.
 */
final class RunToCompletion {

    /**
     * Waits in the queue of a part.
     *
     * @param port of the part
     * @param origin position of the external input that it came in by; {@link EventWiring#INSIDE}
     *     for others
     */
    record Event(int port, Value message, int origin) {}

    /** What has been put on a signal. */
    record Emission(int signal, Sent sent) {}

    private final @Nullable RunToCompletion before;
    private final int length;
    private final List<List<Configuration>> parts;
    private final List<List<Event>> queues;
    private final Value[][] latched;
    private final List<Trace.Cause> causes = new ArrayList<>(1);
    private final List<Emission> emissions = new ArrayList<>(1);
    private int turn;
    private int hash;

    /** Whether the run before could have gone on in another way. */
    private boolean alternative;

    /**
     * The beginning of a run, with empty queues.
     *
     * @param latched by part and port, null where nothing is
     */
    RunToCompletion(List<List<Configuration>> parts, Value[][] latched) {
        this.before = null;
        this.length = 0;
        this.parts = new ArrayList<>(parts);
        this.queues = new ArrayList<>(Collections.nCopies(latched.length, List.of()));
        this.latched = latched;
    }

    private RunToCompletion(RunToCompletion before) {
        this.before = before;
        this.length = before.length + 1;
        this.parts = new ArrayList<>(before.parts);
        this.queues = new ArrayList<>(before.queues);
        this.latched = before.latched.clone();
        this.turn = before.turn;
    }

    /** A run that goes on from here. */
    RunToCompletion longer() {
        return new RunToCompletion(this);
    }

    /** The same, one of several; it may go on differently. */
    RunToCompletion twin() {
        RunToCompletion twin = Objects.requireNonNull(before).longer();
        for (int part = 0; part < latched.length; part++) {
            twin.queues.set(part, queues.get(part));
            twin.latched[part] = latched[part];
        }
        for (int part = 0; part < parts.size(); part++) {
            twin.set(part, parts.get(part));
        }
        twin.causes.addAll(causes);
        twin.turn = turn;
        twin.alternative = true;
        return twin;
    }

    List<Configuration> part(int part) {
        return parts.get(part);
    }

    List<List<Configuration>> parts() {
        return parts;
    }

    void set(int part, List<Configuration> configurations) {
        if (part == parts.size()) {
            parts.add(configurations);
        } else {
            parts.set(part, configurations);
        }
    }

    /** Null where nothing is latched. */
    @Nullable Value latched(int part, int port) {
        return latched[part][port];
    }

    void latch(int part, int port, Value message) {
        Value[] changed = latched[part].clone();
        changed[port] = message;
        latched[part] = changed;
    }

    /** What a part reads when it takes an event. */
    Value[] messages(int part, Event event) {
        Value[] messages = latched[part].clone();
        messages[event.port] = event.message;
        return messages;
    }

    int waiting(int part) {
        return queues.get(part).size();
    }

    void enqueue(int part, Event event) {
        List<Event> queue = new ArrayList<>(queues.get(part));
        queue.add(event);
        queues.set(part, queue);
    }

    boolean isComplete() {
        return queues.stream().allMatch(List::isEmpty);
    }

    /** The part that takes an event next: in order, again and again. */
    int nextPart() {
        int part = turn;
        while (queues.get(part).isEmpty()) {
            part = (part + 1) % queues.size();
        }
        return part;
    }

    /** The event that a part takes next. */
    Event first(int part) {
        return queues.get(part).get(0);
    }

    /** Takes that event. */
    void take(int part) {
        List<Event> queue = queues.get(part);
        queues.set(part, new ArrayList<>(queue.subList(1, queue.size())));
        turn = (part + 1) % queues.size();
    }

    void note(Trace.Cause cause) {
        causes.add(cause);
    }

    void note(int signal, Sent sent) {
        emissions.add(new Emission(signal, sent));
    }

    void setAlternative() {
        alternative = true;
    }

    /** How many reactions it is long. */
    int length() {
        return length;
    }

    /** All that automata did, in order. */
    List<Trace.Cause> causes() {
        List<Trace.Cause> all = new ArrayList<>();
        fromTheBeginning().forEach(run -> all.addAll(run.causes));
        return all;
    }

    /** All that was put on signals, in order. */
    List<Emission> emissions() {
        List<Emission> all = new ArrayList<>();
        fromTheBeginning().forEach(run -> all.addAll(run.emissions));
        return all;
    }

    private Deque<RunToCompletion> fromTheBeginning() {
        Deque<RunToCompletion> runs = new ArrayDeque<>();
        for (RunToCompletion run = this; run != null; run = run.before) {
            runs.addFirst(run);
        }
        return runs;
    }

    /** The latest time that the run was just here before; null if it never was. */
    @Nullable RunToCompletion circleBeginning() {
        for (RunToCompletion run = before; run != null; run = run.before) {
            if (isSame(run)) {
                return run;
            }
        }
        return null;
    }

    /** Whether it might have gone another way since an earlier time. */
    boolean hasAlternativesSince(RunToCompletion earlier) {
        for (RunToCompletion run = this; run != null && run != earlier; run = run.before) {
            if (run.alternative) {
                return true;
            }
        }
        return false;
    }

    /** What was put on signals since an earlier time. */
    List<Emission> emissionsSince(RunToCompletion earlier) {
        List<Emission> all = new ArrayList<>();
        for (RunToCompletion run = this; run != null && run != earlier; run = run.before) {
            all.addAll(run.emissions);
        }
        return all;
    }

    /** Whether both go on in the same ways. */
    private boolean isSame(RunToCompletion other) {
        return hash() == other.hash()
                && turn == other.turn
                && queues.equals(other.queues)
                && parts.equals(other.parts)
                && Arrays.deepEquals(latched, other.latched);
    }

    private int hash() {
        if (hash == 0) {
            hash = Objects.hash(turn, queues, parts, Arrays.deepHashCode(latched));
        }
        return hash;
    }
}

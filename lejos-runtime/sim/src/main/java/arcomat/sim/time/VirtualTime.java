package arcomat.sim.time;

import org.jspecify.annotations.Nullable;

import java.time.Duration;
import java.util.concurrent.Executor;

/**
 * The clock. It stands still while code runs and moves when every thread waits. Waiting allocates
 * nothing, and a thread that is the next to wake does not even stop.
 *
 * <p>Not thread-safe by locks but by the baton: exactly one strand runs at any moment, and only
 * that one calls anything here.
 */
public final class VirtualTime {
    public static final long NEVER = Long.MAX_VALUE;
    public static final long MILLISECOND = 1000;

    private Actor[] actors = new Actor[0];
    private final Strand controller =
            new Strand(Actor.Rank.CONTROLLER, "controller", () -> {}, Runnable::run);
    private @Nullable Strand running = controller;
    private long now;
    private long turns;
    private @Nullable Duration patience;
    private long started;
    private boolean abandoned;

    /** What went wrong in the world while no strand was carried; the controller is told. */
    private @Nullable Throwable failure;

    public VirtualTime() {
        add(controller);
    }

    /** Microseconds since the bricks were switched on. */
    public long now() {
        return now;
    }

    /** The strand that calls; null while the world acts. */
    @SuppressWarnings("NullAway") // who asks while the world acts knows that nobody runs
    public Strand running() {
        return running;
    }

    /** Lets everything happen up to a moment. Called by the controller only. */
    public void runUntil(long moment) {
        controller.isCaller();
        waitUntil(moment);
        Throwable told = failure;
        if (told != null) {
            failure = null;
            throw new IllegalStateException(told);
        }
    }

    /** Returns to the controller as soon as what is due now is done. */
    public void wakeController() {
        schedule(controller, now);
    }

    /**
     * The calling strand waits; others run meanwhile.
     *
     * @throws ProgramEnded if the strand's program is over
     */
    public void waitUntil(long moment) {
        Strand strand = running();
        leaveIfEnded(strand);
        schedule(strand, Math.max(moment, now));
        Strand next = advance();
        if (next != strand) {
            handOver(next);
            await(strand);
        }
        leaveIfEnded(strand);
    }

    private void handOver(Strand next) {
        if (next.isCarried()) {
            next.giveBaton();
        } else {
            next.beCarried(() -> carry(next));
        }
    }

    /** As long as strands follow each other that nobody carries, one thread carries them all. */
    private void carry(Strand first) {
        Strand next = first;
        try {
            while (!next.isCarried()) {
                goOn(next);
                next = advance();
            }
        } catch (RuntimeException | Error e) {
            failure = e;
            running = controller;
            next = controller;
        }
        next.giveBaton();
    }

    private void goOn(Strand strand) {
        boolean rests = false;
        try {
            rests = strand.goOn();
        } finally {
            if (!rests) {
                remove(strand);
            }
        }
    }

    /** Programs that never wait would keep whoever steers the run for ever. */
    private void await(Strand strand) {
        if (strand != controller || patience == null) {
            strand.awaitBaton();
        } else if (!strand.awaitBatonUntil(started + patience.toNanos())) {
            abandoned = true;
            throw new OutOfPatience(patience);
        }
    }

    /**
     * From now on the controller waits so long by the PC's clock, all in all.
     *
     * @see OutOfPatience
     */
    public void limit(Duration newPatience) {
        started = System.nanoTime();
        patience = newPatience;
    }

    /** Whether the controller has given up: programs may still be running, for good. */
    public boolean isAbandoned() {
        return abandoned;
    }

    /** Ends the wait of another strand at this moment. */
    public void wake(Strand strand) {
        if (strand != running && strand.due > now) {
            schedule(strand, now);
        }
    }

    /** Computing takes time on a brick: the calling strand is busy for so long. */
    public void spend(long microseconds) {
        waitUntil(now + microseconds);
    }

    /**
     * Like {@link #waitUntil}, but another strand may cut it short.
     *
     * @throws InterruptedException if it did, before or while waiting
     */
    public void waitInterruptibly(long moment) throws InterruptedException {
        Strand strand = running();
        strand.setInterruptible(true);
        if (!strand.isInterrupted()) {
            waitUntil(moment);
        }
        endWait(strand);
    }

    private void endWait(Strand strand) throws InterruptedException {
        strand.setInterruptible(false);
        if (clearInterrupt()) {
            throw new InterruptedException();
        }
    }

    /**
     * Like {@link #waitInterruptibly}, but the calling strand needs no thread meanwhile: all its
     * calls save their variables and return, and when the time has come its body is called again,
     * which enters them again, up to {@link #rested}.
     *
     * @throws InterruptedException if it was interrupted before; then it does not rest
     */
    public void rest(long moment) throws InterruptedException {
        Strand strand = running();
        strand.setInterruptible(true);
        if (strand.isInterrupted()) {
            endWait(strand);
        }
        leaveIfEnded(strand);
        schedule(strand, Math.max(moment, now));
        strand.rest();
    }

    /**
     * The calling strand has rested.
     *
     * @throws InterruptedException if that was cut short
     */
    public void rested() throws InterruptedException {
        Strand strand = running();
        strand.resumed();
        leaveIfEnded(strand);
        endWait(strand);
    }

    public void interrupt(Strand strand) {
        strand.setInterrupted(true);
        if (strand.isInterruptible()) {
            schedule(strand, now);
        }
    }

    /** Whether the calling strand was interrupted; asking forgets it. */
    public boolean clearInterrupt() {
        boolean was = running().isInterrupted();
        running().setInterrupted(false);
        return was;
    }

    public boolean isInterrupted(Strand strand) {
        return strand.isInterrupted();
    }

    /**
     * A new thread for a program, due now. It runs as soon as the calling strand waits.
     *
     * @param body called again after each rest
     * @param carriers threads of the PC that may carry it
     */
    public Strand start(String name, Runnable body, Executor carriers) {
        Strand strand = new Strand(Actor.Rank.PROGRAM, name, body, carriers);
        add(strand);
        schedule(strand, now);
        return strand;
    }

    /** Unwinds a strand at its next chance. */
    public void end(Strand strand) {
        strand.end();
        if (strand != running && strand.due > now) {
            schedule(strand, now);
        }
    }

    public void start(Timetable timetable, long first) {
        add(timetable);
        schedule(timetable, first);
    }

    public void stop(Timetable timetable) {
        remove(timetable);
    }

    /** Calls a timetable at another moment than it asked for. */
    public void restart(Timetable timetable, long moment) {
        schedule(timetable, moment);
    }

    private void leaveIfEnded(Strand strand) {
        if (!strand.isEnded()) {
            return;
        }
        if (strand.refusesToEnd()) {
            remove(strand);
            handOver(advance());
            strand.awaitBaton(); // for ever
        }
        throw new ProgramEnded();
    }

    /** Moves the clock to the next strand that is due, doing what the world does on the way. */
    private Strand advance() {
        running = null;
        while (true) {
            Actor next = earliest();
            now = Math.max(now, next.due);
            if (next instanceof Strand strand) {
                strand.due = NEVER;
                running = strand;
                return strand;
            }
            schedule(next, ((Timetable) next).act());
        }
    }

    private Actor earliest() {
        Actor first = actors[0];
        for (Actor actor : actors) {
            if (actor.isBefore(first)) {
                first = actor;
            }
        }
        return first;
    }

    private void schedule(Actor actor, long moment) {
        actor.due = moment;
        actor.turn = turns++;
    }

    private void add(Actor actor) {
        Actor[] more = java.util.Arrays.copyOf(actors, actors.length + 1);
        more[actors.length] = actor;
        actors = more;
    }

    private void remove(Actor actor) {
        actors =
                java.util.Arrays.stream(actors)
                        .filter(other -> other != actor)
                        .toArray(Actor[]::new);
    }
}

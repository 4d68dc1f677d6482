package arcomat.sim.time;

import org.jspecify.annotations.Nullable;

import java.util.concurrent.Executor;

/**
 * The clock. It stands still while code runs and moves when every thread waits. Waiting allocates
 * nothing, and a thread that is the next to wake does not even stop.
 *
 * <p>Here the only strand is the controller's, and all else are timetables: so it needs no threads,
 * which a browser has none of. {@link ThreadedTime} has as many strands as programs have threads.
 */
public class VirtualTime {
    public static final long NEVER = Long.MAX_VALUE;
    public static final long MILLISECOND = 1000;

    private Actor[] actors = new Actor[0];
    private final Strand controller =
            new Strand(Actor.Rank.CONTROLLER, "controller", () -> {}, Runnable::run);
    private @Nullable Strand running = controller;
    private long now;
    private long turns;

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
        waitUntil(moment);
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
            giveWay(strand, next);
        }
        leaveIfEnded(strand);
    }

    /** The calling strand waits until it is its turn again; another one goes on. */
    void giveWay(Strand caller, Strand next) {
        throw new IllegalStateException("here are no threads: " + next.name());
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
            leaveBehind(strand);
        }
        throw new ProgramEnded();
    }

    /** The calling strand never goes on; others do. */
    void leaveBehind(Strand strand) {
        remove(strand);
    }

    final Strand controller() {
        return controller;
    }

    /** The controller is to go on, whatever was due. */
    final void returnToController() {
        running = controller;
    }

    /** Moves the clock to the next strand that is due, doing what the world does on the way. */
    final Strand advance() {
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

    final void remove(Actor actor) {
        actors =
                java.util.Arrays.stream(actors)
                        .filter(other -> other != actor)
                        .toArray(Actor[]::new);
    }
}

package arcomat.sim;

import arcomat.sim.device.Lifetime;
import arcomat.sim.memory.CallStack;
import arcomat.sim.time.ProgramEnded;
import arcomat.sim.time.Strand;
import arcomat.sim.time.VirtualTime;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Executor;

/** The threads of one program, from main until the last has ended. */
final class ProgramThreads implements Lifetime {
    private final String name;
    private final VirtualTime time;
    private final Runnable whenOver;
    private final Executor carriers;
    private final Map<Thread, Strand> strands = new IdentityHashMap<>();
    private final Set<Thread> started = Collections.newSetFromMap(new IdentityHashMap<>());
    private final Set<Thread> daemons = Collections.newSetFromMap(new IdentityHashMap<>());
    private final Thread main = new Thread("main");
    private Outcome outcome = Outcome.of(Outcome.Kind.RUNNING);

    /**
     * @param whenOver what the brick does as soon as the program is over
     * @param carriers threads of the PC that carry these
     */
    ProgramThreads(String name, VirtualTime time, Runnable whenOver, Executor carriers) {
        this.name = name;
        this.time = time;
        this.whenOver = whenOver;
        this.carriers = carriers;
    }

    Outcome outcome() {
        return outcome;
    }

    /** Whether the program is over, and no thread of it is left behind. */
    boolean areOver() {
        return outcome.kind() != Outcome.Kind.RUNNING && strands.isEmpty();
    }

    /** A thread object stands for a thread of the program; it is never started itself. */
    @Override
    public void start(Thread thread) {
        if (!started.add(thread)) {
            throw new IllegalThreadStateException("a thread is started only once");
        }
        start(thread, thread);
    }

    /**
     * The thread object of main is never started either.
     *
     * @param body called again after each rest
     */
    void startMain(Runnable body) {
        start(main, body);
    }

    private void start(Thread thread, Runnable body) {
        String full = name + " " + thread.getName();
        strands.put(thread, time.start(full, () -> run(thread, body), carriers));
    }

    private void run(Thread thread, Runnable body) {
        try {
            body.run();
        } catch (ProgramEnded e) {
            // as it should be
        } catch (Throwable e) {
            end(Outcome.failed(e));
        }
        if (!time.running().rests()) {
            ended(thread);
        }
    }

    private void ended(Thread thread) {
        strands.remove(thread);
        if (daemons.containsAll(strands.keySet())) {
            exit();
        }
    }

    @Override
    public boolean isAlive(Thread thread) {
        return strands.containsKey(thread);
    }

    /** Kept here: the thread object would take after the thread of the PC that made it. */
    @Override
    public void setDaemon(Thread thread, boolean on) {
        if (on) {
            daemons.add(thread);
        } else {
            daemons.remove(thread);
        }
    }

    @Override
    public boolean isDaemon(Thread thread) {
        return daemons.contains(thread);
    }

    @Override
    public boolean isMain() {
        return strands.get(main) == time.running();
    }

    @Override
    public Thread current() {
        for (Map.Entry<Thread, Strand> entry : strands.entrySet()) {
            if (entry.getValue() == time.running()) {
                return entry.getKey();
            }
        }
        throw new IllegalStateException("not a thread of the program");
    }

    @Override
    public void interrupt(Thread thread) {
        Strand strand = strands.get(thread);
        if (strand != null) {
            time.interrupt(strand);
        }
    }

    @Override
    public boolean isInterrupted(Thread thread) {
        Strand strand = strands.get(thread);
        return strand != null && time.isInterrupted(strand);
    }

    @Override
    public Map<Thread, CallStack> calls() {
        Map<Thread, CallStack> calls = new IdentityHashMap<>();
        strands.forEach((thread, strand) -> calls.put(thread, strand.calls()));
        return calls;
    }

    @Override
    public void exit() {
        end(Outcome.of(Outcome.Kind.ENDED));
    }

    @Override
    public void abort() {
        end(Outcome.of(Outcome.Kind.ABORTED));
    }

    /** What an observer does not see is unknown: so this counts also where the program is over. */
    void observerFailed(ObserverFailed error) {
        Outcome failed = Outcome.failed(error);
        end(failed);
        if (outcome.kind() != Outcome.Kind.FAILED) {
            outcome = failed;
        }
    }

    /** The first reason counts. */
    void end(Outcome reason) {
        if (outcome.kind() != Outcome.Kind.RUNNING) {
            return;
        }
        outcome = reason;
        whenOver.run();
        strands.values().forEach(time::end);
        time.wakeController();
    }
}

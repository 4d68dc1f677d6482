package arcomat.sim.device;

import arcomat.sim.memory.CallStack;

import java.util.Map;

/** How programs on a brick start threads and how they end. */
public interface Lifetime {
    /** Starts a thread of the program. */
    void start(Thread thread);

    /** Whether the program ends without waiting for a thread. */
    void setDaemon(Thread thread, boolean on);

    boolean isDaemon(Thread thread);

    /** Whether a thread of the program runs. */
    boolean isAlive(Thread thread);

    /** Whether the thread that calls is the one that began in main. */
    boolean isMain();

    /** The thread that calls. */
    Thread current();

    void interrupt(Thread thread);

    /** Whether a thread has been interrupted and not yet noticed. */
    boolean isInterrupted(Thread thread);

    /** The threads that run, with what they have on their stacks. */
    Map<Thread, CallStack> calls();

    /** Ends the program, as leaving main does. */
    void exit();

    /** Ends the program at once, as both buttons together do. */
    void abort();
}

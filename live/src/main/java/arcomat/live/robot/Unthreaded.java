package arcomat.live.robot;

import arcomat.sim.device.Lifetime;
import arcomat.sim.memory.CallStack;

import java.util.Map;

/** Of a program without threads of Java: it goes on as long as the brick is on. */
final class Unthreaded implements Lifetime {
    private static IllegalStateException none() {
        return new IllegalStateException("an interpreted program has no threads of Java");
    }

    @Override
    public void start(Thread thread) {
        throw none();
    }

    @Override
    public void setDaemon(Thread thread, boolean on) {
        throw none();
    }

    @Override
    public boolean isDaemon(Thread thread) {
        throw none();
    }

    @Override
    public boolean isAlive(Thread thread) {
        throw none();
    }

    @Override
    public boolean isMain() {
        return true;
    }

    @Override
    public Thread current() {
        throw none();
    }

    @Override
    public void interrupt(Thread thread) {
        throw none();
    }

    @Override
    public boolean isInterrupted(Thread thread) {
        throw none();
    }

    @Override
    public Map<Thread, CallStack> calls() {
        return Map.of();
    }

    @Override
    public void exit() {}

    @Override
    public void abort() {}
}

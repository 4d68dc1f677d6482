package lejos.util;

import arcomat.sim.device.Hardware;

/**
 * Calls a listener again and again, in a thread of its own that the program does not wait for. As
 * on the brick, the delay begins anew when the listener is through, and a timer that is stopped
 * while it waits calls once more.
 */
public class Timer {
    private static final Hardware BRICK = Hardware.of(Timer.class);

    private final TimerListener listener;
    private final Thread thread = new Thread(this::run, "timer");
    private int delay;
    private boolean isRunning;

    public Timer(int theDelay, TimerListener el) {
        delay = theDelay;
        listener = el;
    }

    private void run() {
        while (true) {
            if (isRunning) {
                BRICK.sleep(delay);
                listener.timedOut();
            } else {
                BRICK.time().waitUntil(BRICK.tickAfter(1));
            }
        }
    }

    public int getDelay() {
        return delay;
    }

    public void setDelay(int newDelay) {
        delay = newDelay;
    }

    public void start() {
        isRunning = true;
        if (!BRICK.lifetime().isAlive(thread)) {
            BRICK.lifetime().setDaemon(thread, true);
            BRICK.lifetime().start(thread);
        }
    }

    public void stop() {
        isRunning = false;
    }
}

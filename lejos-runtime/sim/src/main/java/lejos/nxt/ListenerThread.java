package lejos.nxt;

import arcomat.sim.device.Hardware;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * A thread that calls listeners, one after the other: as on the brick, a listener that takes long
 * delays all others of its thread, and the program ends without waiting for it.
 */
final class ListenerThread extends Thread {
    private static final Hardware BRICK = Hardware.of(ListenerThread.class);

    /** Calls those of buttons and sensors. */
    static final ListenerThread OF_INPUTS = new ListenerThread("listeners");

    /** Calls those of motors. */
    static final ListenerThread OF_MOTORS = new ListenerThread("regulation");

    private final List<Watch> watches = new ArrayList<>();

    private ListenerThread(String name) {
        super(name);
    }

    private static final class Watch {
        private final ListenerCaller caller;
        private final BooleanSupplier hasChanged;
        private final int period;
        private long due;

        Watch(ListenerCaller caller, BooleanSupplier hasChanged, int period) {
            this.caller = caller;
            this.hasChanged = hasChanged;
            this.period = period;
            this.due = BRICK.milliseconds() + period;
        }

        void look(long now) {
            if (due <= now) {
                due = now + period;
                if (hasChanged.getAsBoolean()) {
                    caller.callListeners();
                }
            }
        }
    }

    /**
     * Watches from now on.
     *
     * @param hasChanged whether there is something to tell
     * @param period in milliseconds
     */
    void watch(ListenerCaller caller, BooleanSupplier hasChanged, int period) {
        watches.add(new Watch(caller, hasChanged, period));
        if (watches.size() == 1) {
            BRICK.lifetime().setDaemon(this, true);
            BRICK.lifetime().start(this);
        }
    }

    /** Listeners may bring new ones. */
    @Override
    public void run() {
        while (true) {
            long next = Long.MAX_VALUE;
            for (int i = 0; i < watches.size(); i++) {
                watches.get(i).look(BRICK.milliseconds());
            }
            for (Watch watch : watches) {
                next = Math.min(next, watch.due);
            }
            BRICK.time().waitUntil(BRICK.tickAfter(next - BRICK.milliseconds()));
        }
    }
}

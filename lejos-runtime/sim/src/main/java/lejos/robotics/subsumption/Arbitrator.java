package lejos.robotics.subsumption;

import arcomat.sim.device.Hardware;
import arcomat.sim.inside.BrickMonitors;
import arcomat.sim.inside.BrickSystem;

/**
 * Runs the last of some behaviours that wants control. As on the brick, a second thread keeps
 * asking those behind the running one, and suppresses it if one of them wants control; here both
 * threads look once a millisecond.
 */
public class Arbitrator {
    private static final Hardware BRICK = Hardware.of(Arbitrator.class);
    private static final int NONE = -1;

    private final Behavior[] behaviors;
    private final boolean endsWhenIdle;
    private final Thread monitor = new Thread(this::watch, "arbitrator");
    private int highest = NONE;
    private int active = NONE;
    private boolean isOver;

    public Arbitrator(Behavior[] behaviorList) {
        this(behaviorList, false);
    }

    /**
     * @param returnWhenInactive whether {@link #start} ends when nobody wants control any more
     */
    public Arbitrator(Behavior[] behaviorList, boolean returnWhenInactive) {
        behaviors = behaviorList;
        endsWhenIdle = returnWhenInactive;
        BrickSystem.out.println("Arbitrator created");
    }

    public void start() {
        BRICK.lifetime().setDaemon(monitor, true);
        BRICK.lifetime().start(monitor);
        while (highest == NONE) {
            pause();
        }
        while (true) {
            BrickMonitors.enter(monitor);
            active = highest;
            BrickMonitors.exit(monitor);
            if (active != NONE) {
                behaviors[active].action();
                active = NONE;
            } else if (endsWhenIdle) {
                isOver = true;
                return;
            }
            pause();
        }
    }

    private void watch() {
        while (!isOver) {
            BrickMonitors.enter(monitor);
            try {
                highest = wanting();
                if (active != NONE && highest > active) {
                    behaviors[active].suppress();
                }
            } finally {
                BrickMonitors.exit(monitor);
            }
            pause();
        }
    }

    private int wanting() {
        int running = active;
        for (int i = behaviors.length - 1; i > running; i--) {
            if (behaviors[i].takeControl()) {
                return i;
            }
        }
        return NONE;
    }

    private static void pause() {
        BRICK.time().waitUntil(BRICK.tickAfter(1));
    }
}

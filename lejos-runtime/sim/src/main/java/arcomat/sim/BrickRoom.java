package arcomat.sim;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.Lifetime;
import arcomat.sim.device.Limits;
import arcomat.sim.radio.Ether;
import arcomat.sim.time.Timetable;
import arcomat.sim.time.VirtualTime;

import java.util.function.BooleanSupplier;

/**
 * Where bricks are, all in one virtual time, reaching each other over Bluetooth by their names.
 * Used by one thread.
 */
public class BrickRoom {
    private final VirtualTime time;
    private final Ether ether;
    private final Limits limits;

    BrickRoom(VirtualTime time, Limits limits) {
        this.time = time;
        this.limits = limits;
        this.ether = new Ether(limits.packetsInPieces());
    }

    /** For bricks whose programs have no threads of Java. */
    public static BrickRoom withoutThreads(Limits limits) {
        return new BrickRoom(new VirtualTime(), limits);
    }

    final Ether ether() {
        return ether;
    }

    final Limits limits() {
        return limits;
    }

    /**
     * The devices of a new brick, switched on at this moment, for who works them himself.
     *
     * @param name by which others call it
     * @param lifetime of what works them
     * @throws IllegalArgumentException if another brick has the name
     */
    public final Hardware devices(String name, Lifetime lifetime) {
        return new Hardware(name, time, lifetime, ether.join(name), limits);
    }

    /**
     * Lets something happen around the bricks at a fixed rate, from now on. At the same moment it
     * acts before programs: what they sample then is what it has left.
     *
     * @param period in milliseconds
     * @param step must not wait, nor let time pass
     */
    public final void surround(long period, Runnable step) {
        time.start(
                new Timetable() {
                    @Override
                    protected long act() {
                        step.run();
                        return time.now() + period * VirtualTime.MILLISECOND;
                    }
                },
                time.now());
    }

    /** Milliseconds since the laboratory was opened. */
    public final long time() {
        return time.now() / VirtualTime.MILLISECOND;
    }

    /** Lets time pass up to a moment, also when programs end before. */
    public final void runUntil(long milliseconds) {
        long moment = milliseconds * VirtualTime.MILLISECOND;
        while (time.now() < moment) {
            time.runUntil(moment);
        }
    }

    /**
     * Lets time pass up to a moment, or until somebody who looks regularly says that it is enough.
     *
     * @param period from one look to the next, in milliseconds; the first one is after the first
     * @param isEnough sees everything that happened at the moment; must not wait, nor let time pass
     */
    public final void runUntil(long milliseconds, long period, BooleanSupplier isEnough) {
        Inspection inspection = new Inspection(period * VirtualTime.MILLISECOND, isEnough);
        long moment = milliseconds * VirtualTime.MILLISECOND;
        time.start(inspection, time.now() + inspection.period);
        while (time.now() < moment && !inspection.isOver) {
            time.runUntil(moment);
        }
        time.stop(inspection);
    }

    /** Looks on whichever thread has the baton: waking another one for that would take longer. */
    private final class Inspection extends Timetable {
        private final long period;
        private final BooleanSupplier isEnough;
        private boolean isOver;

        Inspection(long period, BooleanSupplier isEnough) {
            super(Rank.CONTROLLER);
            this.period = period;
            this.isEnough = isEnough;
        }

        @Override
        protected long act() {
            isOver = isEnough.getAsBoolean();
            if (isOver) {
                time.wakeController();
                return VirtualTime.NEVER;
            }
            return time.now() + period;
        }
    }
}

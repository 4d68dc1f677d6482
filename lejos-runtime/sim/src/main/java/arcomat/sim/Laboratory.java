package arcomat.sim;

import arcomat.sim.device.Limits;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Program;
import arcomat.sim.radio.Ether;
import arcomat.sim.time.Timetable;
import arcomat.sim.time.VirtualTime;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Where bricks run, all in one virtual time, reaching each other over Bluetooth by their names.
 * Used by one thread. A run depends on the programs and on what is done to the bricks, and on
 * nothing else: done again, it is the same.
 */
public final class Laboratory implements AutoCloseable {
    /** What runs may take of the PC's time where nobody says: hours of a robot take less. */
    public static final Duration PATIENCE = Duration.ofMinutes(5);

    private final VirtualTime time = new VirtualTime();
    private final Ether ether;
    private final List<SimulatedBrick> bricks = new ArrayList<>();
    private final Limits limits;

    /** For bricks as they are. */
    public Laboratory() {
        this(Limits.OF_THE_BRICK);
    }

    /** For bricks with other limits than real ones have. */
    public Laboratory(Limits limits) {
        this.limits = limits;
        this.ether = new Ether(limits.packetsInPieces());
    }

    /**
     * A new brick, switched on at this moment with a program on it.
     *
     * @throws IllegalArgumentException if another brick has the name, or if the program brings
     *     classes of leJOS or of the simulation, which are there already
     */
    public SimulatedBrick place(String name, Program program) {
        return place(name, LoadedProgram.forOnce(program));
    }

    /** As {@link #place(String, Program)}, where other bricks had the program or will have it. */
    public SimulatedBrick place(String name, LoadedProgram program) {
        SimulatedBrick brick = new SimulatedBrick(name, program, time, ether, limits);
        bricks.add(brick);
        return brick;
    }

    /**
     * From now on all runs together may take so long by the PC's clock; then they end with an
     * {@link arcomat.sim.time.OutOfPatience}. Programs that compute and compute let no time pass.
     */
    public void limit(Duration patience) {
        time.limit(patience);
    }

    /**
     * Lets something happen around the bricks at a fixed rate, from now on. At the same moment it
     * acts before programs: what they sample then is what it has left.
     *
     * @param period in milliseconds
     * @param step must not wait, nor let time pass
     */
    public void surround(long period, Runnable step) {
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
    public long time() {
        return time.now() / VirtualTime.MILLISECOND;
    }

    /** Lets time pass up to a moment, also when programs end before. */
    public void runUntil(long milliseconds) {
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
    public void runUntil(long milliseconds, long period, BooleanSupplier isEnough) {
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

    /** Lets time pass until every program has ended, or up to a moment. */
    public void runToEnd(long milliseconds) {
        long moment = milliseconds * VirtualTime.MILLISECOND;
        while (time.now() < moment && bricks.stream().anyMatch(SimulatedBrick::isRunning)) {
            time.runUntil(moment);
        }
    }

    /** Switches every brick off; programs that nobody could wait for are left behind. */
    @Override
    public void close() {
        if (time.isAbandoned()) {
            return;
        }
        bricks.forEach(SimulatedBrick::stop);
        time.runUntil(time.now());
        bricks.forEach(SimulatedBrick::leave);
    }
}

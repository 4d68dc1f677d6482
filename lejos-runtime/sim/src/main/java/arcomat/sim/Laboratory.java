package arcomat.sim;

import arcomat.sim.device.Limits;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Program;
import arcomat.sim.time.ThreadedTime;
import arcomat.sim.time.VirtualTime;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/**
 * Where bricks run programs in Java. A run depends on the programs and on what is done to the
 * bricks, and on nothing else: done again, it is the same.
 */
public final class Laboratory extends BrickRoom implements AutoCloseable {
    /** What runs may take of the PC's time where nobody says: hours of a robot take less. */
    public static final Duration PATIENCE = Duration.ofMinutes(5);

    private final ThreadedTime time;
    private final List<SimulatedBrick> bricks = new ArrayList<>();

    /** For bricks as they are. */
    public Laboratory() {
        this(Limits.OF_THE_BRICK);
    }

    /** For bricks with other limits than real ones have. */
    public Laboratory(Limits limits) {
        this(new ThreadedTime(), limits);
    }

    private Laboratory(ThreadedTime time, Limits limits) {
        super(time, limits);
        this.time = time;
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
        SimulatedBrick brick = new SimulatedBrick(name, program, time, ether(), limits());
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

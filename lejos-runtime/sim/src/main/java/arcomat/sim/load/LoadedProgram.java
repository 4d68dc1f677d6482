package arcomat.sim.load;

import arcomat.sim.device.Hardware;
import arcomat.sim.time.Carriers;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.concurrent.Executor;

/**
 * A program for bricks. One for many of them makes its class files ready once, and where all its
 * classes can begin again, a brick takes over those that an earlier one has left: the PC's Java has
 * compiled them by then. Else they are loaded anew for every brick. What a program does is the same
 * either way. Bricks of several laboratories, in threads of their own, may share one.
 */
public final class LoadedProgram {
    private final Program program;
    private final boolean once;
    private final List<Probe> probes;
    private final List<NotedLines> lines;
    private final boolean rests;

    /**
     * To each thread that runs laboratories its own: with carriers in common, those of one run
     * would be woken on the processor that is busy with another one.
     */
    private final ThreadLocal<Carriers> carriers = ThreadLocal.withInitial(Carriers::new);

    private @Nullable Stock counted;
    private @Nullable Stock free;

    private LoadedProgram(
            Program program,
            boolean once,
            List<Probe> probes,
            List<NotedLines> lines,
            boolean rests) {
        this.program = program;
        this.once = once;
        this.probes = List.copyOf(probes);
        this.lines = List.copyOf(lines);
        this.rests = rests;
    }

    /** For one brick. */
    public static LoadedProgram forOnce(Program program) {
        return new LoadedProgram(program, true, List.of(), List.of(), false);
    }

    /** For many bricks, one after the other or at the same time. */
    public static LoadedProgram forMany(Program program) {
        return forMany(program, List.of(), List.of());
    }

    /**
     * The same, with probes in it.
     *
     * @param probes observers of its bricks are told when it comes to them
     * @param lines its objects note which of them they have come to
     */
    public static LoadedProgram forMany(
            Program program, List<Probe> probes, List<NotedLines> lines) {
        return new LoadedProgram(program, false, probes, lines, true);
    }

    /**
     * The same program, each of whose threads has one of the PC from its beginning to its end. It
     * does the same, and takes longer.
     */
    public LoadedProgram onThreads() {
        return new LoadedProgram(program, once, probes, lines, false);
    }

    /** Threads of the PC for those of its bricks that the calling thread runs. */
    public Executor carriers() {
        return carriers.get();
    }

    public Program program() {
        return program;
    }

    public String mainClass() {
        return program.mainClass();
    }

    /**
     * The classes for a brick.
     *
     * @throws IllegalArgumentException if the program brings classes of leJOS or of the simulation
     */
    public BrickLoader take(Hardware hardware) {
        return stock(hardware.limits().counted()).take(hardware);
    }

    /** Whether bricks with limits, or without, take over classes that others have left. */
    public boolean repeats(boolean isCounted) {
        return stock(isCounted).repeats();
    }

    /**
     * Whether on bricks with limits, or without, its main thread needs none of the PC's between its
     * slices: the tool has made the program, or it has the same form.
     */
    public boolean rests(boolean isCounted) {
        return stock(isCounted).rests();
    }

    private synchronized Stock stock(boolean isCounted) {
        Stock stock = isCounted ? counted : free;
        if (stock == null) {
            stock =
                    once
                            ? Stock.forOnce(program, isCounted)
                            : Stock.forMany(program, isCounted, probes, lines, rests);
            if (isCounted) {
                counted = stock;
            } else {
                free = stock;
            }
        }
        return stock;
    }

    /** Whether a method is none of the program's: it was added to let a class begin again. */
    public static boolean isAdded(String method) {
        return method.equals(Repetition.READY) || method.equals(Repetition.FIRST);
    }

    /** What a method of a class that begins again is called in its class file. */
    public static String written(String method) {
        return method.equals(Repetition.BEGIN) ? "<clinit>" : SliceLoop.written(method);
    }
}

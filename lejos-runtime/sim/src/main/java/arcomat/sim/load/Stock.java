package arcomat.sim.load;

import arcomat.sim.device.Hardware;

import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;

/** The class files of a program as bricks load them, and loaders that bricks have left. */
final class Stock {
    private final ClassFiles files;
    private final boolean repeats;
    private final boolean rests;
    private final Queue<BrickLoader> left = new ConcurrentLinkedQueue<>();

    private Stock(ClassFiles files, boolean repeats, boolean rests) {
        this.files = files;
        this.repeats = repeats;
        this.rests = rests;
    }

    /** For one brick: what it does not need is not looked at. */
    static Stock forOnce(Program program, boolean counted) {
        return new Stock(
                new Redirected(program, counted, List.of(), List.of(), false), false, false);
    }

    /**
     * For many bricks, one after the other or at the same time.
     *
     * @param rests whether their main threads may rest between slices
     */
    static Stock forMany(
            Program program,
            boolean counted,
            List<Probe> probes,
            List<NotedLines> lines,
            boolean rests) {
        if (rests && GeneratedForm.isOf(program)) {
            try {
                ClassFiles files = new Kept(new Redirected(program, counted, probes, lines, true));
                return new Stock(repeatable(program, files), true, true);
            } catch (RuntimeException e) {
                // What keeps it from this may not keep it from beginning again.
            }
        }
        ClassFiles files = new Kept(new Redirected(program, counted, probes, lines, false));
        try {
            return new Stock(repeatable(program, files), true, false);
        } catch (RuntimeException e) {
            // One cannot begin again, or is not even a class: who needs it will be told so.
            return new Stock(files, false, false);
        }
    }

    /** Makes those of the program at once, to see whether it can be done. */
    private static ClassFiles repeatable(Program program, ClassFiles files) {
        Beginnings beginnings = new Beginnings(files);
        ClassFiles repeatable =
                new Kept(name -> files.find(name).map(file -> Repetition.of(file, beginnings)));
        program.classes().keySet().forEach(repeatable::find);
        return repeatable;
    }

    ClassFiles files() {
        return files;
    }

    /** Whether all classes can begin again. */
    boolean repeats() {
        return repeats;
    }

    /** Whether main threads rest between slices. */
    boolean rests() {
        return rests;
    }

    BrickLoader take(Hardware hardware) {
        BrickLoader loader = left.poll();
        if (loader == null) {
            loader = new BrickLoader(this);
        }
        loader.beginFor(hardware);
        return loader;
    }

    void add(BrickLoader loader) {
        left.add(loader);
    }
}

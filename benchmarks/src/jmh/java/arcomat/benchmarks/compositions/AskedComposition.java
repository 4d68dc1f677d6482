package arcomat.benchmarks.compositions;

import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.packed.PairStore;
import arcomat.benchmarks.measure.Command;
import arcomat.benchmarks.measure.LoweredSources;
import arcomat.model.Component;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.explored.ExploredFolder;
import arcomat.pipeline.explored.ExploredSearches;
import arcomat.semantics.Promise;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The question of a system, asked in a process of its own: {@code philosophers 7}. With {@code
 * explicit} behind, by the search through configurations alone; with {@code disk FOLDER} behind
 * that, by one that keeps what it explores there.
 */
public final class AskedComposition {
    private static final long MOST_STATES = 500_000_000;

    static final String EXPLICIT = "explicit";
    static final String DISK = "disk";

    private AskedComposition() {}

    /**
     * Asks in a process of its own.
     *
     * @param heap the most that it may take, {@code 6g}
     * @param more behind the system
     */
    static List<String> command(String heap, ComposedSystem system, List<String> more) {
        List<String> arguments =
                new ArrayList<>(List.of(system.name(), String.valueOf(system.size())));
        arguments.addAll(more);
        return Command.java(heap, AskedComposition.class, arguments);
    }

    /**
     * How many configurations such a process has told of.
     *
     * @throws IllegalStateException if what is asked does not hold there
     */
    static long configurations(ComposedSystem system, UserTime time) {
        if (!time.output().startsWith("HOLDS ")) {
            throw new IllegalStateException(system.label() + ": " + time.output());
        }
        return Long.parseLong(time.output().split(" ")[1]);
    }

    /** Prints the answer, and how many configurations of the system there are. */
    public static void main(String[] arguments) throws IOException, WrongUse {
        ComposedSystem system = ComposedSystems.of(arguments[0], Integer.parseInt(arguments[1]));
        Component whole =
                LoweredSources.of("load", ArcWriter.texts(system))
                        .component("load.Whole")
                        .orElseThrow();
        boolean explicit = List.of(arguments).contains(EXPLICIT);
        Budget budget =
                new Budget(() -> false, MOST_STATES)
                        .with(rule -> rule != Shortcut.SYMBOLIC || !explicit);
        int disk = List.of(arguments).indexOf(DISK);
        Verdict verdict =
                disk < 0
                        ? verdict(whole, budget, Optional.empty())
                        : onDisk(whole, budget, arguments[disk + 1]);
        System.out.printf("%s %d%n", verdict.answer(), verdict.explored().pairs());
    }

    private static Verdict onDisk(Component whole, Budget budget, String folder)
            throws IOException, WrongUse {
        PathNames names = new PathNames(Path.of("").toAbsolutePath());
        try (ExploredFolder explored =
                        ExploredFolder.ofPromises(folder, List.of(), "measured", names);
                ExploredSearches searches = explored.alone()) {
            Promise promise = Promise.of(whole, List.of());
            return verdict(whole, budget, Optional.of(searches.stores(promise, budget)));
        }
    }

    private static Verdict verdict(
            Component whole, Budget budget, Optional<PairStore.Maker> stores) {
        return InvariantProof.check(whole, List.of(), whole.invariants().get(0), budget, stores);
    }
}

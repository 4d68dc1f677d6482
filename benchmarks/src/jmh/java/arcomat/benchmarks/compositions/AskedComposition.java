package arcomat.benchmarks.compositions;

import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.benchmarks.measure.LoweredSources;
import arcomat.model.Component;

import java.util.List;

/**
 * The question of a system, asked in a process of its own: {@code philosophers 7}. With {@code
 * explicit} behind, by the search through configurations alone.
 */
public final class AskedComposition {
    private static final long MOST_STATES = 500_000_000;

    static final String EXPLICIT = "explicit";

    private AskedComposition() {}

    /** Prints the answer, and how many configurations of the system there are. */
    public static void main(String[] arguments) {
        ComposedSystem system = ComposedSystems.of(arguments[0], Integer.parseInt(arguments[1]));
        Component whole =
                LoweredSources.of("load", ArcWriter.texts(system))
                        .component("load.Whole")
                        .orElseThrow();
        boolean explicit = List.of(arguments).contains(EXPLICIT);
        Budget budget =
                new Budget(() -> false, MOST_STATES)
                        .with(rule -> rule != Shortcut.SYMBOLIC || !explicit);
        Verdict verdict = InvariantProof.check(whole, List.of(), whole.invariants().get(0), budget);
        System.out.printf("%s %d%n", verdict.answer(), verdict.explored().pairs());
    }
}

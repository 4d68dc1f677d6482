package arcomat.analysis.search.encoding;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.packed.NetworkTables.TooLarge;
import arcomat.analysis.search.packed.PackedNetwork.CannotPack;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.system.NetworkSystem;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.analysis.symbolic.InductiveInvariant;
import arcomat.analysis.symbolic.PropertyDirectedReachability;
import arcomat.analysis.symbolic.PropertyDirectedReachability.Progress;
import arcomat.semantics.value.GivenUp;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Whether every trace of a network is one of the right side, without looking at configurations one
 * by one. Says only that it holds, by an inductive invariant that has been checked, or nothing.
 */
public final class SymbolicInclusion {
    private final InclusionBits bits;
    private final InductiveInvariant.Search search;
    private final Budget budget;
    private Progress progress = Progress.WORKS;

    SymbolicInclusion(InclusionBits bits, InductiveInvariant.Search search, Budget budget) {
        this.bits = bits;
        this.search = search;
        this.budget = budget;
    }

    /** Ready to be asked; empty where the question is none for it. */
    public static Optional<SymbolicInclusion> of(
            NetworkSystem left, TransitionSystem right, OutputCubes outputs, Budget budget) {
        try {
            return Optional.of(searched(InclusionBits.of(left, right, outputs), budget));
        } catch (CannotPack | TooLarge unfit) {
            return Optional.empty();
        } catch (GivenUp tooMuch) { // perhaps in what no run ever meets
            budget.insist();
            return Optional.empty();
        }
    }

    private static SymbolicInclusion searched(InclusionBits bits, Budget budget) {
        return new SymbolicInclusion(
                bits, new PropertyDirectedReachability(bits.relation(), budget::insist), budget);
    }

    /** Works on for so long; what has been proved has been checked as well. */
    public Progress work(long amount) {
        if (progress == Progress.WORKS) {
            progress = search.work(amount);
            if (progress == Progress.PROVED && !isProved()) {
                progress = Progress.HOPELESS;
            }
        }
        return progress;
    }

    /** The invariant that was found: what is never so all at once; nothing where none was. */
    public List<List<String>> clauses() {
        StateWords words = bits.words().get();
        return told().map(SymbolicInclusion::inOrder)
                .sorted(SymbolicInclusion::compare)
                .map(cube -> IntStream.of(cube).mapToObj(words::of).toList())
                .toList();
    }

    /** Of how many clauses it is. */
    public int size() {
        return (int) told().count();
    }

    /** Without what goes without saying. */
    private Stream<int[]> told() {
        return search.invariant().stream()
                .flatMap(found -> found.excluded().stream())
                .filter(
                        cube ->
                                bits.granted().stream()
                                        .noneMatch(each -> Arrays.equals(each, cube)));
    }

    /** By position. */
    private static int[] inOrder(int[] cube) {
        return IntStream.of(cube)
                .boxed()
                .sorted(Comparator.comparingInt(Math::abs))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    private static int compare(int[] one, int[] other) {
        for (int i = 0; i < one.length && i < other.length; i++) {
            if (one[i] != other[i]) {
                return Integer.compare(one[i], other[i]);
            }
        }
        return Integer.compare(one.length, other.length);
    }

    private boolean isProved() {
        Optional<InductiveInvariant> invariant = search.invariant();
        return invariant.isPresent() && invariant.get().proves(bits.relation(), budget::insist);
    }
}

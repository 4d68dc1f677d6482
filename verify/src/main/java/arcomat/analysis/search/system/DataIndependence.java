package arcomat.analysis.search.system;

import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.letter.Representatives;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.DataSorts;
import arcomat.semantics.expression.DataSorts.Sort;
import arcomat.semantics.value.SmallType;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;

/**
 * The data of a comparison that both sides only pass on and compare: with other values in their
 * stead, they do the same (data independence: Wolper, "Expressing interesting properties of
 * programs in propositional temporal logic", POPL 1986). So it is enough to try letters with the
 * values that a pair of configurations holds, with constants, and with some that neither side
 * knows. If a run of the left side from there is none of the right side, then it stays so when each
 * value that the pair does not hold changes places with another one of the same kind; for the pair
 * itself that changes nothing. A search that goes on from pair to pair finds counterexamples as
 * short as with all values.
 *
 * <p>It ends where pairs hold finitely many values: strangers are always the first ones that a pair
 * does not hold.
 */
public final class DataIndependence {
    private final DataSorts sorts = new DataSorts();

    /** Null where no input has data that are worth it. */
    private final @Nullable DataPlaces left;

    private final @Nullable DataPlaces right;

    private final Sort[] ofInputs;
    private final boolean any;
    private final Map<Integer, List<Value>> nothing = new HashMap<>();

    /** Numbers of sorts by their places, as far as they have been asked for. */
    private final Map<Integer, Integer> sortOfPlace = new HashMap<>();

    private final Map<Integer, Map<Integer, List<Value>>> heldLeft = new HashMap<>();
    private final Map<Integer, Map<Integer, List<Value>>> heldRight = new HashMap<>();
    private final Numbering<Map<Integer, List<Value>>> held = new Numbering<>();

    /**
     * @param observed how many output ports are compared
     */
    public DataIndependence(TransitionSystem left, TransitionSystem right, int observed) {
        List<Port> inputs = left.inputs();
        ofInputs = new Sort[inputs.size()];
        boolean large = inputs.stream().anyMatch(port -> SmallType.values(port.type()).isEmpty());
        DataPlaces mine = large ? left.data(sorts) : null;
        DataPlaces theirs = large ? right.data(sorts) : null;
        if (mine != null && theirs != null) {
            for (Port port : right.inputs()) {
                join(mine.input(port.name()), theirs.input(port.name()));
            }
            for (int port = 0; port < observed; port++) {
                join(mine.outputs().get(port), theirs.outputs().get(port));
            }
            for (int i = 0; i < ofInputs.length; i++) {
                ofInputs[i] = free(mine, inputs.get(i));
            }
        }
        this.left = mine;
        this.right = theirs;
        any = !nothing.isEmpty();
    }

    private void join(int one, int other) {
        if (one != DataPlaces.NOWHERE && other != DataPlaces.NOWHERE) {
            sorts.join(one, other);
        }
    }

    private @Nullable Sort free(DataPlaces places, Port input) {
        Sort sort = sorts.sort(places.input(input.name()));
        if (!sort.free() || SmallType.values(input.type()).isPresent()) {
            return null;
        }
        nothing.put(sort.number(), List.of());
        return sort;
    }

    /** Whether an input has such data. */
    public boolean isFree(int port) {
        return ofInputs[port] != null;
    }

    /** Whether there are such data. */
    public boolean any() {
        return any;
    }

    /** The number of what a pair holds. */
    public int held(int configuration, int[] members) {
        Map<Integer, Set<Value>> all = new HashMap<>();
        nothing.keySet().forEach(sort -> all.put(sort, new TreeSet<>()));
        collect(heldLeft.computeIfAbsent(configuration, each -> held(left, each)), all);
        for (int member : members) {
            collect(heldRight.computeIfAbsent(member, each -> held(right, each)), all);
        }
        Map<Integer, List<Value>> values = new HashMap<>();
        all.forEach((sort, some) -> values.put(sort, List.copyOf(some)));
        return held.number(values);
    }

    /** The number of what a configuration of both sides, if they are one, holds. */
    public int held(int configuration) {
        return held(configuration, new int[] {configuration});
    }

    private static void collect(Map<Integer, List<Value>> some, Map<Integer, Set<Value>> all) {
        some.forEach((sort, values) -> Objects.requireNonNull(all.get(sort)).addAll(values));
    }

    private Map<Integer, List<Value>> held(@Nullable DataPlaces data, int configuration) {
        Map<Integer, List<Value>> found = new HashMap<>();
        Objects.requireNonNull(data)
                .memory()
                .tell(
                        configuration,
                        (place, value) -> {
                            int sort =
                                    sortOfPlace.computeIfAbsent(
                                            place, each -> sorts.sort(each).number());
                            if (nothing.containsKey(sort)) {
                                found.computeIfAbsent(sort, each -> new ArrayList<>()).add(value);
                            }
                        });
        return found;
    }

    /** What is tried in a pair that holds something. */
    public Representatives representatives(int number) {
        return new Representatives(ofInputs, held.get(number));
    }
}

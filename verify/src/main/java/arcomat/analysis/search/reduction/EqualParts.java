package arcomat.analysis.search.reduction;

import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Groups of parts of a network, equal in their order, that may be put in each other's places: runs
 * become runs, and what the question looks at stays the same. So of the configurations that come
 * from each other in this way, one is enough (Ip, Dill, "Better verification through symmetry",
 * 1996).
 *
 * @param ring whether each group may only take the place of the next one, all together; else any
 *     two may change places
 * @param groups positions of their parts
 */
public record EqualParts(boolean ring, List<int[]> groups) {
    private static final int MOST_NAMED = 5;

    /**
     * Those that are found, none of them in two.
     *
     * @param observed signals that the question is about
     * @param mayErr whether a run may end in an error
     */
    public static List<EqualParts> of(Network network, int[] observed, boolean mayErr) {
        if (mayErr && mayStandStill(network)) {
            return List.of();
        }
        PartWiring wires = new PartWiring(network, observed);
        List<EqualParts> found = new ArrayList<>();
        BitSet tried = new BitSet();
        for (int part = 0; part < network.instances().size(); part++) {
            if (!tried.get(part)) {
                Optional<EqualParts> equal = at(wires, part, tried);
                equal.ifPresent(found::add);
                equal.ifPresent(e -> e.groups.forEach(g -> Arrays.stream(g).forEach(tried::set)));
            }
            tried.set(part);
        }
        return found;
    }

    /** Where one part stands still and another one ends the run, the first of them decides. */
    private static boolean mayStandStill(Network network) {
        return network.instances().stream().anyMatch(i -> i.component().automata().size() > 1);
    }

    private static Optional<EqualParts> at(PartWiring wires, int part, BitSet tried) {
        int[] equal =
                IntStream.range(part + 1, wires.network.instances().size())
                        .filter(other -> !tried.get(other) && wires.areEqual(part, other))
                        .toArray();
        return inAnyOrder(wires, part, equal, tried).or(() -> inRing(wires, part, equal, tried));
    }

    private static Optional<EqualParts> inAnyOrder(
            PartWiring wires, int part, int[] equal, BitSet tried) {
        BitSet own = new BitSet();
        BitSet taken = (BitSet) tried.clone();
        List<int[]> groups = new ArrayList<>();
        for (int other : equal) {
            Optional<WiringMap> swap = WiringMap.swapping(wires, part, other);
            if (swap.isEmpty() || !own.isEmpty() && !own.equals(swap.get().withFirst)) {
                continue;
            }
            int[] first = swap.get().withFirst.stream().toArray();
            int[] group = Arrays.stream(first).map(p -> swap.get().parts[p]).toArray();
            BitSet all = new BitSet();
            IntStream.concat(Arrays.stream(first), Arrays.stream(group)).forEach(all::set);
            if (all.cardinality() != 2 * first.length
                    || all.intersects(tried)
                    || !all.equals(moved(swap.get()))
                    || Arrays.stream(group).anyMatch(taken::get)
                    || Arrays.stream(first).anyMatch(p -> !isBack(swap.get(), p))) {
                continue;
            }
            if (groups.isEmpty()) {
                own = swap.get().withFirst;
                groups.add(first);
                taken.or(own);
            }
            groups.add(group);
            Arrays.stream(group).forEach(taken::set);
        }
        return groups.isEmpty() ? Optional.empty() : Optional.of(new EqualParts(false, groups));
    }

    private static boolean isBack(WiringMap swap, int part) {
        return swap.parts[swap.parts[part]] == part;
    }

    private static BitSet moved(WiringMap map) {
        BitSet moved = new BitSet();
        for (int part = 0; part < map.parts.length; part++) {
            moved.set(part, map.parts[part] != part);
        }
        return moved;
    }

    /** The way round that has most places. */
    private static Optional<EqualParts> inRing(
            PartWiring wires, int part, int[] equal, BitSet tried) {
        Optional<EqualParts> longest = Optional.empty();
        for (int next : equal) {
            Optional<EqualParts> ring =
                    WiringMap.moving(wires, part, next)
                            .filter(map -> !moved(map).intersects(tried))
                            .flatMap(map -> ring(map, part));
            if (ring.isPresent()
                    && ring.get().groups.size()
                            > longest.map(EqualParts::groups).map(List::size).orElse(1)) {
                longest = ring;
            }
        }
        return longest;
    }

    private static Optional<EqualParts> ring(WiringMap map, int part) {
        List<int[]> groups = new ArrayList<>();
        BitSet open = moved(map);
        int count = open.cardinality();
        List<Integer> first = new ArrayList<>();
        int length = round(map, part, open);
        first.add(part);
        for (int p = open.nextSetBit(0); p >= 0; p = open.nextSetBit(p)) {
            first.add(p);
            if (round(map, p, open) != length) {
                return Optional.empty();
            }
        }
        int[] group = first.stream().sorted().mapToInt(Integer::intValue).toArray();
        for (int place = 0; place < length; place++) {
            groups.add(group);
            group = Arrays.stream(group).map(p -> map.parts[p]).toArray();
        }
        return count == length * first.size()
                ? Optional.of(new EqualParts(true, groups))
                : Optional.empty();
    }

    /** How many places a part has on its way round. */
    private static int round(WiringMap map, int part, BitSet open) {
        int length = 0;
        int p = part;
        do {
            open.clear(p);
            p = map.parts[p];
            length++;
        } while (p != part);
        return length;
    }

    /** In words, with the paths of first parts. */
    public String text(Network network) {
        String named =
                groups.stream()
                        .limit(MOST_NAMED)
                        .map(group -> network.instances().get(group[0]).path())
                        .collect(Collectors.joining(", "));
        String rest = groups.size() > MOST_NAMED ? ".." : "";
        return (ring
                                ? "looked at in one of %d places, since it is a ring of equal"
                                        + " parts: "
                                : "looked at in one order, since these %d parts are equal: ")
                        .formatted(groups.size())
                + named
                + rest;
    }
}

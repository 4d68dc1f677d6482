package arcomat.graph;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/** Components, cycles and order against a matrix of what reaches what. */
class DigraphProperties {
    private static Digraph random(long seed) {
        Random random = new Random(seed);
        int size = random.nextInt(9);
        Digraph graph = new Digraph(size);
        for (int i = random.nextInt(2 * size + 1); size > 0 && i > 0; i--) {
            graph.addEdge(random.nextInt(size), random.nextInt(size));
        }
        return graph;
    }

    /** Per pair, the number of edges of a shortest way, at least one; 0 where there is none. */
    private static int[][] distances(Digraph graph) {
        int size = graph.size();
        int[][] distances = new int[size][size];
        for (int from = 0; from < size; from++) {
            for (int to : graph.successors(from)) {
                distances[from][to] = 1;
            }
        }
        for (int over = 0; over < size; over++) {
            for (int from = 0; from < size; from++) {
                for (int to = 0; to < size; to++) {
                    int first = distances[from][over];
                    int second = distances[over][to];
                    int known = distances[from][to];
                    if (first > 0 && second > 0 && (known == 0 || first + second < known)) {
                        distances[from][to] = first + second;
                    }
                }
            }
        }
        return distances;
    }

    @Property
    void whatCanBeReached(@ForAll long seed) {
        Digraph graph = random(seed);
        int[][] distances = distances(graph);
        for (int node = 0; node < graph.size(); node++) {
            BitSet expected = new BitSet();
            for (int other = 0; other < graph.size(); other++) {
                expected.set(other, distances[node][other] > 0);
            }
            assertThat(graph.reachableFrom(node)).isEqualTo(expected);
        }
    }

    @Property
    void componentsAreWhatReachesEachOther(@ForAll long seed) {
        Digraph graph = random(seed);
        int[][] distances = distances(graph);
        StrongComponents components = StrongComponents.of(graph);
        List<Integer> cyclic = new ArrayList<>();
        for (int[] nodes : components.cyclic()) {
            assertThat(nodes).isSorted();
            IntStream.of(nodes).forEach(cyclic::add);
        }
        for (int one = 0; one < graph.size(); one++) {
            assertThat(cyclic.contains(one)).isEqualTo(distances[one][one] > 0);
            for (int other = 0; other < graph.size(); other++) {
                assertThat(components.areTogether(one, other))
                        .isEqualTo(
                                one == other
                                        || distances[one][other] > 0 && distances[other][one] > 0);
            }
        }
        assertThat(cyclic).doesNotHaveDuplicates();
    }

    @Property
    void componentsComeAfterWhatTheyLeadTo(@ForAll long seed) {
        Digraph graph = random(seed);
        int[][] distances = distances(graph);
        List<int[]> cyclic = StrongComponents.of(graph).cyclic();
        for (int i = 0; i < cyclic.size(); i++) {
            for (int[] later : cyclic.subList(i + 1, cyclic.size())) {
                assertThat(distances[cyclic.get(i)[0]][later[0]]).isZero();
            }
        }
    }

    @Property
    void cyclesAreCyclesAndAsShortAsTheyGet(@ForAll long seed) {
        Digraph graph = random(seed);
        int[][] distances = distances(graph);
        List<List<Integer>> cycles = ShortestCycles.of(graph);
        assertThat(cycles.stream().map(cycle -> cycle.get(0)).toList())
                .isEqualTo(
                        StrongComponents.of(graph).cyclic().stream()
                                .map(nodes -> nodes[0])
                                .sorted()
                                .toList());
        for (List<Integer> cycle : cycles) {
            assertThat(cycle).hasSize(distances[cycle.get(0)][cycle.get(0)]);
            for (int i = 0; i < cycle.size(); i++) {
                assertThat(graph.successors(cycle.get(i)))
                        .contains(cycle.get((i + 1) % cycle.size()));
            }
        }
    }

    @Property
    void orderLeadsForwardAndTakesTheLowestFirst(@ForAll long seed) {
        Digraph graph = random(seed);
        int[][] distances = distances(graph);
        List<Integer> left =
                new ArrayList<>(
                        IntStream.range(0, graph.size())
                                .filter(node -> isFree(node, distances))
                                .boxed()
                                .toList());
        List<Integer> expected = new ArrayList<>();
        while (!left.isEmpty()) {
            int next =
                    left.stream()
                            .filter(node -> left.stream().allMatch(o -> distances[o][node] == 0))
                            .findFirst()
                            .orElseThrow();
            expected.add(next);
            left.remove((Integer) next);
        }
        assertThat(TopologicalOrder.of(graph)).isEqualTo(expected);
    }

    /** No cycle leads to it. */
    private static boolean isFree(int node, int[][] distances) {
        return distances[node][node] == 0
                && IntStream.range(0, distances.length)
                        .noneMatch(o -> distances[o][o] > 0 && distances[o][node] > 0);
    }

    @Test
    void chainsAreNotTooLongForTheStack() {
        int size = 200_000;
        Digraph ring = new Digraph(size);
        for (int node = 0; node < size; node++) {
            ring.addEdge(node, (node + 1) % size);
        }
        assertThat(StrongComponents.of(ring).cyclic()).hasSize(1);
        assertThat(ShortestCycles.of(ring).get(0)).hasSize(size);
        assertThat(ring.reachableFrom(0).cardinality()).isEqualTo(size);
    }
}

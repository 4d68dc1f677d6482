package arcomat.analysis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Random;

/** What falls is what a naive iteration says, whenever demands are made. */
class AttractorTest {
    private static final int NODES = 8;
    private static final int DEMANDS = 14;
    private static final int ROUNDS = 2_000;

    private record Demand(int owner, int[] answers) {}

    @Test
    void isTheLeastFixedPoint() {
        Random random = new Random(1);
        for (int round = 0; round < ROUNDS; round++) {
            Attractor attractor = new Attractor();
            List<Demand> demands = new ArrayList<>();
            for (int i = 0; i < DEMANDS; i++) {
                int[] answers = random.ints(random.nextInt(4), 0, NODES).toArray();
                Demand demand = new Demand(random.nextInt(NODES), answers);
                demands.add(demand);
                attractor.demand(demand.owner, answers);
                if (random.nextBoolean()) {
                    attractor.propagate();
                }
            }
            attractor.propagate();
            assertThat(attractor.fallen()).isEqualTo(naive(demands));
        }
    }

    private static BitSet naive(List<Demand> demands) {
        BitSet fallen = new BitSet();
        for (int before = -1; before < fallen.cardinality(); ) {
            before = fallen.cardinality();
            for (Demand demand : demands) {
                boolean answered = false;
                for (int answer : demand.answers) {
                    answered |= !fallen.get(answer);
                }
                fallen.set(demand.owner, fallen.get(demand.owner) || !answered);
            }
        }
        return fallen;
    }

    @Test
    void whatFallsForItselfTakesOthersAlong() {
        Attractor attractor = new Attractor();
        assertThat(attractor.demand(0, new int[] {1, 1})).isTrue();
        attractor.fall(1);
        attractor.propagate();
        assertThat(attractor.isFallen(0)).isTrue();
        assertThat(attractor.demand(2, new int[] {0})).isFalse();
        assertThat(attractor.isFallen(2)).isTrue();
    }
}

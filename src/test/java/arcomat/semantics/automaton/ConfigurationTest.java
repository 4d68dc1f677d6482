package arcomat.semantics.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Value;

import org.junit.jupiter.api.Test;

import java.util.HashSet;
import java.util.Set;

class ConfigurationTest {
    private static Configuration counters(int state, int... counters) {
        Value[] values = new Value[counters.length];
        for (int i = 0; i < counters.length; i++) {
            values[i] = new Value.IntegerValue(counters[i]);
        }
        return new Configuration(state, values);
    }

    @Test
    void stateAndVariablesMakeADifference() {
        assertThat(counters(1, 2, 3)).isEqualTo(counters(1, 2, 3));
        assertThat(counters(1, 2, 3)).isNotEqualTo(counters(2, 2, 3));
        assertThat(counters(1, 2, 3)).isNotEqualTo(counters(1, 3, 2));
        assertThat(counters(0)).isNotEqualTo(Configuration.CHAOS);
    }

    /** Analyses keep thousands of them in sets. */
    @Test
    void smallCountersDoNotCollide() {
        Set<Integer> hashes = new HashSet<>();
        for (int a = 0; a < 20; a++) {
            for (int b = 0; b < 20; b++) {
                for (int c = 0; c < 20; c++) {
                    hashes.add(counters(a % 3, a, b, c).hashCode());
                }
            }
        }
        assertThat(hashes).hasSizeGreaterThan(7900);
    }
}

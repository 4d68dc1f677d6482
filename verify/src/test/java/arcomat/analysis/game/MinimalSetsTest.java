package arcomat.analysis.game;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** Sets of digits: what has the property contains one of those that are listed. */
class MinimalSetsTest {
    private static final BitSet ALL = set("0123456");

    /** The first one by what its last member is: early members are preferred. */
    @ParameterizedTest
    @ValueSource(
            strings = {"0", "6", "01 23", "23 456", "012 23", "05 1234", "0123456", "16 25 34"})
    void one(String minimal) {
        BitSet found = MinimalSets.of(ALL, set -> holds(set, sets(minimal)));
        assertThat(found)
                .isEqualTo(
                        sets(minimal).stream()
                                .min(Comparator.comparingInt(BitSet::length))
                                .orElseThrow());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "0", "3 6", "01 23", "012 23", "05 12 346", "01 02 12", "012 345 6"})
    void every(String minimal) {
        List<BitSet> found = MinimalSets.all(ALL, rest -> some(rest, sets(minimal)), () -> false);
        assertThat(found)
                .containsExactlyElementsOf(
                        sets(minimal).stream().sorted(MinimalSets.SMALL_FIRST).toList());
    }

    @ParameterizedTest
    @ValueSource(strings = {"01 23 45"})
    void asManyAsThereIsTimeFor(String minimal) {
        int[] asked = {0};
        List<BitSet> found =
                MinimalSets.all(ALL, rest -> some(rest, sets(minimal)), () -> asked[0]++ > 0);
        assertThat(found).hasSize(1);
    }

    private static Optional<BitSet> some(BitSet rest, Collection<BitSet> minimal) {
        return holds(rest, minimal)
                ? Optional.of(MinimalSets.of(rest, set -> holds(set, minimal)))
                : Optional.empty();
    }

    private static boolean holds(BitSet set, Collection<BitSet> minimal) {
        return minimal.stream()
                .anyMatch(
                        each -> {
                            BitSet missing = (BitSet) each.clone();
                            missing.andNot(set);
                            return missing.isEmpty();
                        });
    }

    private static List<BitSet> sets(String words) {
        List<BitSet> sets = new ArrayList<>();
        Arrays.stream(words.split(" "))
                .filter(word -> !word.isEmpty())
                .map(MinimalSetsTest::set)
                .forEach(sets::add);
        return sets;
    }

    private static BitSet set(String digits) {
        BitSet set = new BitSet();
        digits.chars().forEach(digit -> set.set(digit - '0'));
        return set;
    }
}

package arcomat.analysis.search.packed;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;

/** Numbers for packed keys, beside a map of lists; and fields, beside an array. */
class PackedTableTest {
    private static final int MANY = 40_000;

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7})
    void numbersKeysAsTheyCome(int words) {
        Random random = new Random(words);
        PackedTable table = new PackedTable(words);
        Map<List<Long>, Integer> numbers = new HashMap<>();
        for (int i = 0; i < MANY; i++) {
            long[] key = random.longs(words, 0, words == 1 ? MANY : 25).toArray();
            key[words - 1] <<= random.nextInt(3) * 20;
            List<Long> boxed = Arrays.stream(key).boxed().toList();
            Integer known = numbers.putIfAbsent(boxed, numbers.size());
            assertThat(table.find(key)).isEqualTo(known == null ? -1 : known);
            assertThat(table.add(key)).isEqualTo(known == null ? ~(numbers.size() - 1) : known);
        }
        assertThat(table.size()).isEqualTo(numbers.size());
        numbers.forEach(
                (key, number) -> {
                    long[] found = new long[words];
                    table.get(number, found);
                    assertThat(Arrays.stream(found).boxed().toList()).isEqualTo(key);
                });
    }

    @Test
    void fieldsKeepWhatTheyAreGiven() {
        Random random = new Random(5);
        for (int round = 0; round < 500; round++) {
            int[] widths = random.ints(1 + random.nextInt(40), 0, 32).toArray();
            int[] values = values(widths, random);
            PackedLayout layout = PackedLayout.of(widths);
            long[] words = packed(layout, values);
            assertThat(unpacked(layout, words, widths.length)).isEqualTo(values);
            int cleared = random.nextInt(widths.length);
            layout.clear(words, cleared);
            values[cleared] = 0;
            assertThat(unpacked(layout, words, widths.length)).isEqualTo(values);
            for (int field = 0; field < widths.length; field++) {
                assertThat(layout.fits(field, values[field])).isTrue();
                assertThat(layout.fits(field, 1 << widths[field] & Integer.MAX_VALUE))
                        .isEqualTo(widths[field] == 31);
            }
        }
    }

    @Test
    void tablesMoveToWiderLayouts() {
        Random random = new Random(6);
        for (int round = 0; round < 100; round++) {
            int[] widths = random.ints(1 + random.nextInt(20), 0, 12).toArray();
            int[] wider = Arrays.stream(widths).map(w -> w + random.nextInt(3)).toArray();
            PackedLayout from = PackedLayout.of(widths);
            PackedLayout to = PackedLayout.of(wider);
            PackedTable table = new PackedTable(from.words());
            List<int[]> kept = new ArrayList<>();
            for (int i = 0; i < 200; i++) {
                int[] values = values(widths, random);
                if (table.add(packed(from, values)) < 0) {
                    kept.add(values);
                }
            }
            PackedTable moved = table.moved(from, to);
            assertThat(moved.size()).isEqualTo(kept.size());
            long[] words = new long[to.words()];
            for (int number = 0; number < kept.size(); number++) {
                moved.get(number, words);
                assertThat(unpacked(to, words, widths.length)).isEqualTo(kept.get(number));
                assertThat(moved.find(words)).isEqualTo(number);
            }
        }
    }

    private static int[] values(int[] widths, Random random) {
        return Arrays.stream(widths).map(w -> (int) (random.nextLong() & (1L << w) - 1)).toArray();
    }

    private static long[] packed(PackedLayout layout, int[] values) {
        long[] words = new long[layout.words()];
        for (int field = 0; field < values.length; field++) {
            layout.put(words, field, values[field]);
        }
        return words;
    }

    private static int[] unpacked(PackedLayout layout, long[] words, int fields) {
        return IntStream.range(0, fields).map(field -> layout.get(words, field)).toArray();
    }
}

package arcomat.analysis.game.controller;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/** Boxes are what the table is, and few. */
class BoxCoverTest {

    /** As many digits as cells, those of the last port change fastest. */
    @ParameterizedTest
    @CsvSource({
        "2 2, 0000, 1",
        "2 2, 0011, 2",
        "2 2, 0101, 2",
        "2 2, 0001, 3",
        "2 2, 0110, 4",
        "3 2, 010101, 2",
        "3 2, 000111, 4",
        "3 2, 010001, 3",
        "2 3 2, 010101010101, 2",
        "2 3 2, 000011000011, 2",
        "2 2 2, 00000001, 4",
    })
    void boxes(String sizes, String cells, int boxes) {
        int[] ports = Arrays.stream(sizes.split(" ")).mapToInt(Integer::parseInt).toArray();
        int[] table = cells.chars().map(c -> c - '0').toArray();
        assertThat(checked(ports, table)).hasSize(boxes);
    }

    /** That port comes first which divides the table into the fewest parts. */
    @Test
    void manyPorts() {
        int[] sizes = {3, 3, 3, 2};
        int[] cells = IntStream.range(0, 54).map(i -> i % 2 == 0 ? 0 : i).toArray();
        assertThat(checked(sizes, cells)).hasSize(1 + 27);
    }

    @Test
    void anyTable() {
        Random random = new Random(1);
        for (int round = 0; round < 300; round++) {
            int[] sizes = random.ints(1 + random.nextInt(5), 1, 4).toArray();
            int contents = 1 + random.nextInt(3);
            int size = Arrays.stream(sizes).reduce(1, (one, two) -> one * two);
            checked(sizes, random.ints(size, 0, contents).toArray());
        }
    }

    /** Each cell is in one box, which has its content. */
    private static List<BoxCover.Box> checked(int[] sizes, int[] cells) {
        List<BoxCover.Box> boxes = BoxCover.of(sizes, cells);
        for (int cell = 0; cell < cells.length; cell++) {
            int[] samples = samples(sizes, cell);
            List<Integer> contents =
                    boxes.stream()
                            .filter(box -> contains(box, samples))
                            .map(BoxCover.Box::content)
                            .toList();
            assertThat(contents).containsExactly(cells[cell]);
        }
        return boxes;
    }

    private static int[] samples(int[] sizes, int cell) {
        int[] samples = new int[sizes.length];
        int rest = cell;
        for (int port = sizes.length - 1; port >= 0; port--) {
            samples[port] = rest % sizes[port];
            rest /= sizes[port];
        }
        return samples;
    }

    private static boolean contains(BoxCover.Box box, int[] samples) {
        return IntStream.range(0, samples.length)
                .allMatch(
                        port ->
                                box.groups()[port] == null
                                        || Arrays.stream(box.groups()[port])
                                                .anyMatch(sample -> sample == samples[port]));
    }
}

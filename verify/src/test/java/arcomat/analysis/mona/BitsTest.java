package arcomat.analysis.mona;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.mona.Bits.Condition;
import arcomat.analysis.mona.Bits.Cube;
import arcomat.analysis.mona.Bits.Literal;

import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** What is said of numbers bit by bit is true of these numbers and of no others. */
class BitsTest {
    @Property(tries = 500)
    void ofSetsOfNumbers(
            @ForAll @IntRange(min = 1, max = 40) int count,
            @ForAll @IntRange(min = 0, max = 3) int first,
            @ForAll Set<@IntRange(min = 0, max = 39) Integer> chosen) {
        Bits bits = Bits.named("b", count);
        Set<Integer> possible =
                IntStream.range(Math.min(first, count - 1), count)
                        .boxed()
                        .collect(Collectors.toSet());
        Set<Integer> numbers =
                chosen.stream().filter(possible::contains).collect(Collectors.toSet());
        Condition condition = bits.isIn(numbers, possible, "t");
        for (int number : possible) {
            assertThat(holds(condition, number))
                    .as("%d", number)
                    .isEqualTo(numbers.contains(number));
        }
    }

    @Property(tries = 200)
    void ofBounds(@ForAll @IntRange(min = 0, max = 70) int most) {
        Bits bits = Bits.named("b", most + 1);
        List<Condition> bounds = bits.isAtMost(most, "t");
        for (int number = 0; number < 1 << bits.names().size(); number++) {
            int each = number;
            assertThat(bounds.stream().allMatch(bound -> holds(bound, each)))
                    .as("%d", number)
                    .isEqualTo(number <= most);
        }
    }

    @Example
    void intervalsTakeFewCubes() {
        Bits bits = Bits.named("b", 4097);
        Set<Integer> all = IntStream.range(0, 4097).boxed().collect(Collectors.toSet());
        Set<Integer> low = IntStream.range(0, 1000).boxed().collect(Collectors.toSet());
        assertThat(bits.isIn(low, all, "t").cubes()).hasSizeLessThan(13);
    }

    @Example
    void asksNothing() {
        Cube none = new Cube(List.of());
        Cube some = new Cube(List.of(new Literal("b0", "t", true)));
        assertThat(Condition.of(none).isTrue()).isTrue();
        assertThat(Condition.of(some).isTrue()).isFalse();
        assertThat(Condition.not(none).isTrue()).isFalse();
        assertThat(new Condition(true, List.of()).isTrue()).isTrue();
        assertThat(new Condition(false, List.of()).isTrue()).isFalse();
    }

    private static boolean holds(Condition condition, int number) {
        return condition.cubes().stream().anyMatch(cube -> holds(cube, number))
                != condition.negated();
    }

    private static boolean holds(Cube cube, int number) {
        return cube.literals().stream().allMatch(literal -> holds(literal, number));
    }

    private static boolean holds(Literal literal, int number) {
        int bit = Integer.parseInt(literal.variable().substring(1));
        return ((number >> bit & 1) == 1) == literal.member();
    }
}

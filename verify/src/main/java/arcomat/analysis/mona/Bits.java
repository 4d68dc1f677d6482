package arcomat.analysis.mona;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * A number in binary.
 *
 * @param names of the bits, the lowest first
 */
record Bits(List<String> names) {
    /** Enough bits for so many numbers, at least one. */
    static Bits named(String prefix, int numbers) {
        int count = Math.max(1, 32 - Integer.numberOfLeadingZeros(numbers - 1));
        return new Bits(IntStream.range(0, count).mapToObj(i -> prefix + i).toList());
    }

    /** The number at a position is this one. */
    Cube is(int number, String position) {
        List<Literal> literals = new ArrayList<>();
        for (int bit = names.size() - 1; bit >= 0; bit--) {
            literals.add(new Literal(names.get(bit), position, (number >> bit & 1) == 1));
        }
        return new Cube(literals);
    }

    /** The number at a position is one of these; what is said of other numbers does not matter. */
    Condition isIn(Collection<Integer> numbers, Collection<Integer> possible, String position) {
        Set<Integer> others = new HashSet<>(possible);
        others.removeAll(numbers);
        List<Cube> positive = cover(new HashSet<>(numbers), position);
        List<Cube> negative = cover(others, position);
        return negative.size() < positive.size()
                ? new Condition(true, negative)
                : new Condition(false, positive);
    }

    /** The number at a position is not greater than this one. */
    List<Condition> isAtMost(int most, String position) {
        List<Condition> bounds = new ArrayList<>();
        List<Literal> ones = new ArrayList<>();
        for (int bit = names.size() - 1; bit >= 0; bit--) {
            Literal one = new Literal(names.get(bit), position, true);
            if ((most >> bit & 1) == 1) {
                ones.add(one);
            } else {
                List<Literal> greater = new ArrayList<>(ones);
                greater.add(one);
                bounds.add(Condition.not(new Cube(greater)));
            }
        }
        return bounds;
    }

    private List<Cube> cover(Set<Integer> numbers, String position) {
        List<Cube> cubes = new ArrayList<>();
        cover(numbers, names.size() - 1, position, List.of(), cubes);
        return cubes;
    }

    /** Splits by the highest bit, unless it makes no difference. */
    private void cover(
            Set<Integer> numbers, int bit, String position, List<Literal> above, List<Cube> cubes) {
        if (numbers.isEmpty()) {
            return;
        }
        if (numbers.size() == 1L << (bit + 1)) {
            cubes.add(new Cube(above));
            return;
        }
        Set<Integer> low = new HashSet<>();
        Set<Integer> high = new HashSet<>();
        numbers.forEach(n -> ((n >> bit & 1) == 1 ? high : low).add(n & (1 << bit) - 1));
        if (low.equals(high)) {
            cover(low, bit - 1, position, above, cubes);
            return;
        }
        cover(low, bit - 1, position, plus(above, bit, position, false), cubes);
        cover(high, bit - 1, position, plus(above, bit, position, true), cubes);
    }

    private List<Literal> plus(List<Literal> above, int bit, String position, boolean member) {
        List<Literal> longer = new ArrayList<>(above);
        longer.add(new Literal(names.get(bit), position, member));
        return longer;
    }

    /** A bit of the number at a position. */
    public record Literal(String variable, String position, boolean member) {}

    /** All of these. */
    public record Cube(List<Literal> literals) {}

    /**
     * One of these; or, negated, none of them.
     *
     * @param cubes without one, the condition is false, and negated true
     */
    public record Condition(boolean negated, List<Cube> cubes) {
        static Condition of(Cube cube) {
            return new Condition(false, List.of(cube));
        }

        static Condition not(Cube cube) {
            return new Condition(true, List.of(cube));
        }

        /** Whether it asks nothing. */
        boolean isTrue() {
            return negated
                    ? cubes.isEmpty()
                    : cubes.stream().anyMatch(cube -> cube.literals.isEmpty());
        }
    }
}

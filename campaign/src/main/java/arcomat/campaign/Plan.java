package arcomat.campaign;

import java.util.function.Function;

/** Which values and seeds the runs of a campaign have. */
public sealed interface Plan {
    /** Takes the sum apart: one answer for each form. */
    <R> R match(Function<Random, R> random, Function<Latin, R> latin, Function<Grid, R> grid);

    /**
     * Each run draws its values.
     *
     * @param runs how many there are at most
     */
    record Random(long runs) implements Plan {
        @Override
        public <R> R match(
                Function<Random, R> random, Function<Latin, R> latin, Function<Grid, R> grid) {
            return random.apply(this);
        }
    }

    /**
     * Values are drawn so that each of {@code runs} equal parts of each range is met once (McKay,
     * Beckman, Conover: A comparison of three methods for selecting values of input variables,
     * Technometrics 21, 1979).
     */
    record Latin(long runs) implements Plan {
        @Override
        public <R> R match(
                Function<Random, R> random, Function<Latin, R> latin, Function<Grid, R> grid) {
            return latin.apply(this);
        }
    }

    /**
     * Every value with every other.
     *
     * @param steps of each range; words are taken all
     * @param seeds runs at each point; all points have the same ones
     */
    record Grid(int steps, int seeds) implements Plan {
        @Override
        public <R> R match(
                Function<Random, R> random, Function<Latin, R> latin, Function<Grid, R> grid) {
            return grid.apply(this);
        }
    }
}

package arcomat.campaign;

import arcomat.source.Span;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;

/**
 * A parameter of the world that a campaign gives values to.
 *
 * @param parameter its name in the world
 * @param place where the campaign names it
 */
public record Variation(String parameter, Domain domain, Span place) {
    /** Which values there are. */
    public sealed interface Domain {
        /** Takes the sum apart: one answer for each form. */
        <R> R match(Function<Range, R> range, Function<Choice, R> choice);

        /**
         * The value at a place of the whole, as it is written in the world's text.
         *
         * @param share from 0 to 1, the end excluded but for grids
         */
        String at(double share);
    }

    /**
     * Numbers from {@code low} to {@code high}, both included.
     *
     * @param whole whether only whole ones
     */
    public record Range(double low, double high, boolean whole) implements Domain {
        /** Decimals that a world can read, and finer than anything in it. */
        private static final int DECIMALS = 6;

        @Override
        public <R> R match(Function<Range, R> range, Function<Choice, R> choice) {
            return range.apply(this);
        }

        @Override
        public String at(double share) {
            if (whole) {
                double numbers = high - low + 1;
                return text(Math.min(high, low + Math.floor(share * numbers)));
            }
            return text(low + share * (high - low));
        }

        /** Without an exponent, and without zeros that say nothing. */
        private static String text(double number) {
            BigDecimal rounded =
                    BigDecimal.valueOf(number).setScale(DECIMALS, RoundingMode.HALF_EVEN);
            return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
        }

        /** The numbers of a grid with so many steps; fewer where there are not so many. */
        List<String> steps(int count) {
            if (count == 1 || low == high) {
                return List.of(text(low));
            }
            return IntStream.range(0, count)
                    .mapToDouble(step -> low + (high - low) * step / (count - 1))
                    .map(number -> whole ? Math.rint(number) : number)
                    .mapToObj(Range::text)
                    .distinct()
                    .toList();
        }
    }

    /** Words of which one stands in the world. */
    public record Choice(List<String> words) implements Domain {
        public Choice {
            words = List.copyOf(words);
        }

        @Override
        public <R> R match(Function<Range, R> range, Function<Choice, R> choice) {
            return choice.apply(this);
        }

        @Override
        public String at(double share) {
            return words.get((int) Math.min(words.size() - 1, share * words.size()));
        }
    }

    /** The values that a grid has of it. */
    public List<String> steps(int count) {
        return domain.match(range -> range.steps(count), Choice::words);
    }
}

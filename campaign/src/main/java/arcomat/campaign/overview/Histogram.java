package arcomat.campaign.overview;

import arcomat.campaign.Column;

import java.util.Arrays;
import java.util.List;

/**
 * How often a measure had which number.
 *
 * @param counts for each step of the scale; empty where no run had a number
 * @param never runs in which it did not come to a number: it is infinite
 * @param unknown runs that have none, such as a distance to another robot where there is one
 */
public record Histogram(Column column, Scale scale, List<Long> counts, long never, long unknown) {
    private static final int BINS = 24;

    public Histogram {
        counts = List.copyOf(counts);
    }

    /** The first look: between which numbers they are. */
    static final class Extent {
        private double least = Double.POSITIVE_INFINITY;
        private double greatest = Double.NEGATIVE_INFINITY;
        private boolean whole = true;

        void see(double number) {
            if (Double.isFinite(number)) {
                least = Math.min(least, number);
                greatest = Math.max(greatest, number);
                whole &= number == Math.rint(number);
            }
        }

        Scale scale() {
            return least > greatest
                    ? new Scale(0, 0, 1, false)
                    : Scale.around(least, greatest, BINS, whole);
        }
    }

    /** The second look: how many are where. */
    static final class Count {
        private final Column column;
        private final Scale scale;
        private final long[] counts;
        private long never;
        private long unknown;

        Count(Column column, Extent extent) {
            this.column = column;
            this.scale = extent.scale();
            this.counts = new long[scale.steps()];
        }

        void see(double number) {
            if (Double.isNaN(number)) {
                unknown++;
            } else if (Double.isInfinite(number)) {
                never++;
            } else {
                counts[scale.step(number)]++;
            }
        }

        Histogram histogram() {
            List<Long> all = Arrays.stream(counts).boxed().toList();
            boolean none = all.stream().allMatch(each -> each == 0);
            return new Histogram(column, scale, none ? List.of() : all, never, unknown);
        }
    }
}

package arcomat.benchmarks.measure;

import java.util.Map;

/**
 * A ratio, a difference or a figure that should stay below a limit.
 *
 * @param measured label of the product's benchmark
 * @param reference label of what it is compared with; empty where the figure itself is limited
 * @param factor what to multiply the ratio with, for times of different amounts of work
 * @param difference whether what is limited is how much more the product's is, in its own unit
 * @param promised whether missing it is a failure of the product; otherwise it is an aim
 */
public record Goal(
        String text,
        String measured,
        String reference,
        double factor,
        double limit,
        boolean difference,
        boolean promised) {

    public static Goal promise(String text, String measured, String reference, double limit) {
        return new Goal(text, measured, reference, 1, limit, false, true);
    }

    public static Goal aim(String text, String measured, String reference, double limit) {
        return new Goal(text, measured, reference, 1, limit, false, false);
    }

    /** How much more, at most, in the unit of both. */
    public static Goal difference(String text, String measured, String reference, double limit) {
        return new Goal(text, measured, reference, 1, limit, true, true);
    }

    /** What is measured itself, in its own unit. */
    public static Goal limit(String text, String measured, double limit) {
        return new Goal(text, measured, "", 1, limit, false, true);
    }

    public Goal times(double otherFactor) {
        return new Goal(text, measured, reference, otherFactor, limit, difference, promised);
    }

    public double value(Map<String, Measurement> results) {
        double median = results.get(measured).median();
        if (reference.isEmpty()) {
            return factor * median;
        }
        double other = results.get(reference).median();
        return difference ? median - other : factor * median / other;
    }
}

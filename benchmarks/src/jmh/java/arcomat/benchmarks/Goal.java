package arcomat.benchmarks;

import java.util.Map;

/**
 * A ratio that should stay below a limit.
 *
 * @param measured label of the product's benchmark
 * @param reference label of what it is compared with
 * @param factor what to multiply the ratio with, for times of different amounts of work
 * @param promised whether missing it is a failure of the product; otherwise it is an aim
 */
public record Goal(
        String text,
        String measured,
        String reference,
        double factor,
        double limit,
        boolean promised) {

    public static Goal promise(String text, String measured, String reference, double limit) {
        return new Goal(text, measured, reference, 1, limit, true);
    }

    public static Goal aim(String text, String measured, String reference, double limit) {
        return new Goal(text, measured, reference, 1, limit, false);
    }

    public Goal times(double otherFactor) {
        return new Goal(text, measured, reference, otherFactor, limit, promised);
    }

    double ratio(Map<String, Measurement> results) {
        return factor * results.get(measured).median() / results.get(reference).median();
    }
}

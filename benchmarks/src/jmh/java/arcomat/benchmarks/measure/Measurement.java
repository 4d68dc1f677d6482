package arcomat.benchmarks.measure;

import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.util.ListStatistics;
import org.openjdk.jmh.util.Statistics;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The result of one benchmark.
 *
 * @param label method and parameters, {@code generated 0.9}
 * @param median over all iterations of all forks
 * @param low quarter of the iterations below
 * @param high quarter of the iterations above
 * @param unit as JMH names it, {@code ns/op}
 */
public record Measurement(String label, double median, double low, double high, String unit) {

    public static Map<String, Measurement> of(Collection<RunResult> results) {
        Map<String, Measurement> measurements = new TreeMap<>();
        for (RunResult result : results) {
            Measurement measurement = of(result);
            measurements.put(measurement.label(), measurement);
        }
        return measurements;
    }

    private static Measurement of(RunResult result) {
        var primary = result.getPrimaryResult();
        return of(label(result), primary.getStatistics(), primary.getScoreUnit());
    }

    /** Of single times, taken without JMH. */
    public static Measurement of(String label, List<Double> times, String unit) {
        ListStatistics statistics = new ListStatistics();
        times.forEach(statistics::addValue);
        return of(label, statistics, unit);
    }

    /** Adds what was taken once. */
    public static void put(
            Map<String, Measurement> results, String label, double value, String unit) {
        results.put(label, of(label, List.of(value), unit));
    }

    private static Measurement of(String label, Statistics statistics, String unit) {
        return new Measurement(
                label,
                statistics.getPercentile(50),
                statistics.getPercentile(25),
                statistics.getPercentile(75),
                unit);
    }

    private static String label(RunResult result) {
        String name = result.getParams().getBenchmark();
        StringBuilder label = new StringBuilder(name.substring(name.lastIndexOf('.') + 1));
        for (String key : result.getParams().getParamsKeys()) {
            label.append(' ').append(result.getParams().getParam(key));
        }
        return label.toString();
    }
}

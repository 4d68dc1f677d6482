package arcomat.report.brick;

import arcomat.sim.trace.Lateness;

import java.util.Locale;

/**
 * In words, how often a program came late: {@code 12 slices came late; the longest took 141 ms}.
 */
public final class LatenessText {
    private static final double MILLISECOND = 1000;

    private LatenessText() {}

    /** For a program that has come late. */
    public static String of(Lateness lateness) {
        return String.format(
                Locale.ROOT,
                "%d %s came late; the longest took %.1f ms",
                lateness.slices(),
                lateness.slices() == 1 ? "slice" : "slices",
                lateness.longest() / MILLISECOND);
    }
}

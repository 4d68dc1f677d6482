package arcomat.benchmarks.measure;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Times contestants in turn, many short rounds each, and keeps the fastest round of each. Unlike
 * the median of a long run this hardly suffers from a machine that does other work at times, and
 * then only in the same way for all.
 */
public final class Alternation {
    private static final int ROUNDS = 300;

    /** Long enough for the virtual machine to compile a large method on a busy machine. */
    private static final long WARM_UP_NANOSECONDS = 4_000_000_000L;

    private Alternation() {}

    /**
     * @param contestants by name
     * @param operations in one run of a contestant
     * @return a line of nanoseconds per operation
     */
    public static String of(String title, Map<String, Runnable> contestants, long operations) {
        contestants.values().forEach(Alternation::warmUp);
        Map<String, Double> fastest = new LinkedHashMap<>();
        int repetitions = (int) Math.max(1, 200_000 / operations);
        for (int round = 0; round < ROUNDS; round++) {
            contestants.forEach(
                    (name, run) -> {
                        double time = time(run, repetitions) / repetitions / operations;
                        fastest.merge(name, time, Math::min);
                    });
        }
        StringBuilder line = new StringBuilder(title + ", in turn, fastest round, ns:");
        fastest.forEach((name, time) -> line.append(" %s %.2f".formatted(name, time)));
        return line.toString();
    }

    private static void warmUp(Runnable run) {
        long start = System.nanoTime();
        while (System.nanoTime() - start < WARM_UP_NANOSECONDS) {
            run.run();
        }
    }

    private static double time(Runnable run, int repetitions) {
        long start = System.nanoTime();
        for (int i = 0; i < repetitions; i++) {
            run.run();
        }
        return System.nanoTime() - start;
    }
}

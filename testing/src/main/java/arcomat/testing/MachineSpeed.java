package arcomat.testing;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * How much longer a computation takes now than on the quiet machine that the times of the project
 * were measured on. Processor time is no constant: processes beside each other share caches and the
 * units of a core.
 */
final class MachineSpeed {
    /** Seconds of processor time that the work takes on that machine. */
    private static final double QUIET = 0.13;

    private static final int REPETITIONS = 3;
    private static final int KEYS = 200_000;

    private MachineSpeed() {}

    /** At least 1. */
    static double slowness() {
        double shortest = Double.MAX_VALUE;
        for (int i = 0; i < REPETITIONS; i++) {
            shortest = Math.min(shortest, seconds());
        }
        return Math.max(1, shortest / QUIET);
    }

    private static double seconds() {
        long begun = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        int found = work();
        long ended = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        if (found != KEYS) {
            throw new IllegalStateException(found + " keys instead of " + KEYS);
        }
        return (ended - begun) / 1e9;
    }

    /** Texts, lists and a map, of which most of the tests' time is made. */
    private static int work() {
        Map<String, List<Integer>> positions = new HashMap<>();
        for (int i = 0; i < KEYS; i++) {
            positions.computeIfAbsent("key " + i * 31, key -> new ArrayList<>()).add(i);
        }
        return positions.size();
    }
}

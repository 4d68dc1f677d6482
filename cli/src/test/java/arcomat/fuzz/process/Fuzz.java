package arcomat.fuzz.process;

import java.nio.file.Path;
import java.util.Map;

/**
 * Gives the installed tool damaged input for some minutes: {@code ./gradlew fuzz -Pminutes=N
 * -Pseed=S -Pkinds=K}. Each kind gets the same time, and with the same seed the same inputs, as
 * many as there is time for. What the tool does not take as it should is kept below {@code
 * build/fuzz}.
 */
public final class Fuzz {
    private static final int MOST_FINDINGS = 100;
    private static final int LONGEST_FINDING = 3000;

    private Fuzz() {}

    /**
     * @param arguments minutes; a seed, or nothing for a new one; a part of the names of kinds
     */
    public static void main(String[] arguments) throws Exception {
        double minutes = Double.parseDouble(arguments[0]);
        long seed = arguments[1].isEmpty() ? System.nanoTime() : Long.parseLong(arguments[1]);
        System.out.println("seed " + seed);
        int told = 0;
        long start = System.nanoTime();
        try (FuzzRun run = new FuzzRun(seed, arguments[2], Path.of("build/fuzz/" + seed))) {
            while (System.nanoTime() - start < minutes * 60e9 && told < MOST_FINDINGS) {
                run.once();
                for (; told < run.findings().size(); told++) {
                    String finding = run.findings().get(told);
                    System.out.println(
                            "== "
                                    + finding.substring(
                                            0, Math.min(LONGEST_FINDING, finding.length())));
                }
            }
            print(run, (System.nanoTime() - start) / 60e9, seed);
        }
        System.exit(told == 0 ? 0 : 1);
    }

    private static void print(FuzzRun run, double minutes, long seed) {
        int inputs = 0;
        int processes = 0;
        for (Map.Entry<Kind, FuzzRun.Tally> each : run.tallies().entrySet()) {
            FuzzRun.Tally tally = each.getValue();
            inputs += tally.inputs;
            processes += tally.processes;
            System.out.printf(
                    "%-8s %7d inputs, %7d calls (exit status 0: %d, 1: %d, 2: %d, 3: %d),"
                            + " %5d as processes of their own, %d findings%n",
                    each.getKey().name(),
                    tally.inputs,
                    tally.calls,
                    tally.statuses[0],
                    tally.statuses[1],
                    tally.statuses[2],
                    tally.statuses[3],
                    tally.processes,
                    tally.found);
        }
        System.out.printf(
                "%d inputs in %.1f minutes, %d processes of their own; seed %d%n",
                inputs, minutes, processes, seed);
    }
}

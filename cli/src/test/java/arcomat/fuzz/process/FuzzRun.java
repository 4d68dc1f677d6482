package arcomat.fuzz.process;

import arcomat.fuzz.Dice;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;

/**
 * Gives the tool damaged input, of all kinds in turn. Most calls go to a warm process; some are
 * made once more as a process of their own, and both have to say and write the same.
 */
final class FuzzRun implements AutoCloseable {
    /** One of so many inputs goes to a process of its own as well. */
    private static final int COLD_EACH = 20;

    private static final int UNKNOWN = 3;

    /** How a kind fared. */
    static final class Tally {
        long nanos;
        int inputs;
        int calls;
        int processes;
        int found;
        final int[] statuses = new int[UNKNOWN + 1];
    }

    private final long seed;
    private final Path folder;
    private final Sandbox sandbox;
    private final Tool warm;
    private final Tool cold;
    private final Map<Kind, Tally> tallies = new LinkedHashMap<>();
    private final List<String> findings = new ArrayList<>();

    /**
     * @param kinds a regular expression for a part of the names of kinds
     * @param folder where work is done, and findings are written
     */
    FuzzRun(long seed, String kinds, Path folder) throws IOException, InterruptedException {
        this.seed = seed;
        this.folder = folder.toAbsolutePath();
        this.sandbox = new Sandbox(this.folder.resolve("work"));
        Files.createDirectories(this.folder);
        warm = new WarmTool(sandbox.temporary(), this.folder.resolve("warm.err"));
        cold = new ColdTool(this.folder.resolve("streams"));
        Seeds seeds = new Seeds(warm, sandbox);
        for (Kind kind :
                List.of(
                        new DamagedModels(seeds),
                        new DamagedJars(seeds),
                        new DamagedScripts(seeds),
                        new DamagedWorlds(seeds),
                        new DamagedStates(seeds),
                        new DamagedTargets(seeds))) {
            if (kind.name().matches(".*(?:" + kinds + ").*")) {
                tallies.put(kind, new Tally());
            }
        }
    }

    Map<Kind, Tally> tallies() {
        return tallies;
    }

    List<String> findings() {
        return findings;
    }

    /** One input of the kind that has had the least time. */
    void once() throws IOException, InterruptedException {
        Kind kind =
                tallies.keySet().stream()
                        .min((a, b) -> Long.compare(tallies.get(a).nanos, tallies.get(b).nanos))
                        .orElseThrow();
        once(kind);
    }

    /** The next input of a kind. */
    void once(Kind kind) throws IOException, InterruptedException {
        Tally tally = tallies.get(kind);
        long before = System.nanoTime();
        int number = tally.inputs++;
        Input input = input(kind, number);
        List<String> faults = new ArrayList<>();
        List<Outcome> outcomes = run(warm, input, faults, tally);
        SortedMap<String, byte[]> result = sandbox.content();
        if (number % COLD_EACH == 0 && faults.isEmpty()) {
            List<Outcome> again = run(cold, input, faults, tally);
            tally.processes += again.size();
            compare(outcomes, again, faults);
            if (faults.isEmpty() && !isOpen(outcomes) && !same(result, sandbox.content())) {
                faults.add("writes something else as a process of its own");
            }
        }
        tally.nanos += System.nanoTime() - before;
        if (!faults.isEmpty()) {
            tally.found++;
            note(kind.name() + "-" + number, input, outcomes, faults);
        }
    }

    /** The same for the same seed. */
    Input input(Kind kind, int number) {
        return kind.draw(new Dice(seed * 1_000_003 + kind.name().hashCode() * 31L + number));
    }

    private List<Outcome> run(Tool tool, Input input, List<String> faults, Tally tally)
            throws IOException, InterruptedException {
        List<Outcome> outcomes = new ArrayList<>();
        sandbox.fill(input.files());
        for (Call call : input.calls()) {
            SortedMap<String, byte[]> before = sandbox.content();
            Outcome outcome = tool.run(sandbox, call);
            outcomes.add(outcome);
            faults.addAll(Verdict.faults(input, call, outcome, before, sandbox.content()));
            if (tool == warm) {
                tally.calls++;
                outcome.status().ifPresent(s -> tally.statuses[Math.min(s, UNKNOWN)]++);
            }
        }
        agree(input, outcomes, faults);
        return outcomes;
    }

    /** Calls in a row that have to say the same. */
    private static void agree(Input input, List<Outcome> outcomes, List<String> faults) {
        boolean pair = outcomes.size() == 2;
        boolean state = pair && !input.calls().get(0).option("--state").isEmpty();
        if (state && !outcomes.get(0).out().equals(outcomes.get(1).out())) {
            faults.add("a file of state changes what is found");
        }
        boolean format = input.calls().get(0).command().equals("format");
        if (pair
                && format
                && outcomes.get(0).status().equals(Optional.of(0))
                && !outcomes.get(1).status().equals(Optional.of(0))) {
            faults.add("what was formatted is not canonical");
        }
    }

    private static void compare(List<Outcome> outcomes, List<Outcome> again, List<String> faults) {
        for (int i = 0; i < outcomes.size(); i++) {
            Outcome one = outcomes.get(i);
            Outcome other = again.get(i);
            if (one.status().equals(Optional.of(UNKNOWN))
                    || other.status().equals(Optional.of(UNKNOWN))) {
                return; // how far it got is not the same each time
            }
            if (!one.status().equals(other.status())) {
                faults.add("as a process, exit status " + other.status());
            } else if (!one.out().equals(other.out()) || !one.err().equals(other.err())) {
                faults.add("as a process it says\n" + other.said());
            }
        }
    }

    private static boolean isOpen(List<Outcome> outcomes) {
        return outcomes.stream().anyMatch(o -> o.status().equals(Optional.of(UNKNOWN)));
    }

    private static boolean same(SortedMap<String, byte[]> one, SortedMap<String, byte[]> other) {
        return one.keySet().equals(other.keySet())
                && one.keySet().stream()
                        .allMatch(path -> java.util.Arrays.equals(one.get(path), other.get(path)));
    }

    /** Keeps what was found: the input as files, the calls, and what came of them. */
    private void note(String name, Input input, List<Outcome> outcomes, List<String> faults)
            throws IOException {
        Sandbox place = new Sandbox(folder.resolve(name));
        place.fill(input.files());
        StringBuilder text = new StringBuilder();
        faults.forEach(fault -> text.append(fault).append('\n'));
        for (int i = 0; i < outcomes.size(); i++) {
            text.append("$ arcomat ").append(quoted(input.calls().get(i))).append('\n');
            Outcome outcome = outcomes.get(i);
            text.append("status ").append(outcome.status()).append(", ");
            text.append("%.1f s\n".formatted(outcome.seconds())).append(outcome.said());
        }
        Files.writeString(place.base().resolve("finding.txt"), text);
        findings.add(place.base() + "\n" + text);
    }

    private static String quoted(Call call) {
        return call.arguments().stream()
                .map(argument -> argument.matches("[\\w./=-]+") ? argument : "'" + argument + "'")
                .collect(java.util.stream.Collectors.joining(" "));
    }

    @Override
    public void close() throws IOException {
        warm.close();
        cold.close();
        sandbox.clear();
    }
}

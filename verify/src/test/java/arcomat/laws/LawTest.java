package arcomat.laws;

import arcomat.laws.Law.Outcome;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Tries the laws on random models for some minutes: {@code ./gradlew lawTest -Pminutes=N -Pseed=S}.
 * Each law gets the same time, and with the same seed the same models, as many as there is time
 * for. What breaks one is made small and written below {@code build/laws}.
 */
public final class LawTest {
    /** Of findings of one kind, so many are made small and written. */
    private static final int MOST_ALIKE = 2;

    private static final int MOST_FINDINGS = 500;

    /** How a law fared. */
    private static final class Tally {
        long nanos;
        int drawn;
        int models;
        int met;
        int broken;
    }

    private final long seed;
    private final Set<Features> features;
    private final Path folder;
    private final List<Law> laws;
    private final Map<Law, Tally> tallies = new LinkedHashMap<>();
    private final Map<String, Integer> told = new HashMap<>();
    private int findings;

    private LawTest(long seed, Set<Features> features, List<Law> laws) {
        this.seed = seed;
        this.features = features;
        this.folder = Path.of("build/laws", String.valueOf(seed));
        this.laws = laws;
        laws.forEach(law -> tallies.put(law, new Tally()));
    }

    /**
     * @param arguments minutes; a seed, or nothing for a new one; features to leave out; a part of
     *     the names of the laws to try
     */
    public static void main(String[] arguments) throws IOException {
        double minutes = Double.parseDouble(arguments[0]);
        long seed = arguments[1].isEmpty() ? System.nanoTime() : Long.parseLong(arguments[1]);
        List<Law> laws =
                Laws.ALL.stream()
                        .filter(law -> law.name().matches(".*(?:" + arguments[3] + ").*"))
                        .toList();
        LawTest test = new LawTest(seed, Features.without(arguments[2]), laws);
        System.out.println("seed " + seed);
        boolean kept = test.run((long) (minutes * 60e9));
        System.exit(kept ? 0 : 1);
    }

    private boolean run(long nanos) throws IOException {
        warmUp();
        long start = System.nanoTime();
        while (System.nanoTime() - start < nanos && findings < MOST_FINDINGS) {
            Law law =
                    laws.stream()
                            .min(Comparator.comparingLong(l -> tallies.get(l).nanos))
                            .orElseThrow();
            Tally tally = tallies.get(law);
            long before = System.nanoTime();
            int number = tally.drawn++;
            Draw draw = new Draw(seed * 1_000_003 + law.name().hashCode() + number, features);
            List<SourceFile> files = law.draw(draw);
            Optional<Outcome> outcome = Trial.check(law, files, number);
            tally.nanos += System.nanoTime() - before;
            if (outcome.isPresent()) {
                tally.models++;
                tally.met += outcome.get().met() ? 1 : 0;
                if (outcome.get().isBroken()) {
                    tally.broken++;
                    findings++;
                    if (told.merge(law.name() + Shrinking.kind(outcome.get()), 1, Integer::sum)
                            <= MOST_ALIKE) {
                        note(law, files, number, outcome.get());
                    }
                }
            }
        }
        print((System.nanoTime() - start) / 60e9);
        return findings == 0;
    }

    /** What is slow because it is the first would count against its law. */
    private void warmUp() {
        for (Law law : laws) {
            for (int number = 0; number < 5; number++) {
                Trial.check(law, law.draw(new Draw(number, features)), number);
            }
        }
    }

    private void note(Law law, List<SourceFile> files, int number, Outcome outcome)
            throws IOException {
        Shrinking.Smallest smallest = Shrinking.of(law, files, number, outcome);
        Path place = folder.resolve(findings + "-" + law.name().replace(' ', '-'));
        StringBuilder text = new StringBuilder();
        text.append("law ")
                .append(law.name())
                .append(", number ")
                .append(number)
                .append("\n")
                .append(smallest.outcome().problem())
                .append("\n");
        smallest.outcome().commands().forEach(c -> text.append("  ").append(c).append("\n"));
        for (SourceFile file : smallest.files()) {
            write(place.resolve(file.path()), file.text());
            text.append("-- ").append(file.path()).append("\n").append(file.text());
        }
        for (Map.Entry<String, String> test : smallest.outcome().tests().entrySet()) {
            write(place.resolve(test.getKey()), test.getValue());
            text.append("-- ").append(test.getKey()).append("\n").append(test.getValue());
        }
        write(place.resolve("finding.txt"), text.toString());
        System.out.println("== " + place + "\n" + text);
    }

    private static void write(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }

    private void print(double minutes) {
        int models = 0;
        for (Map.Entry<Law, Tally> each : tallies.entrySet()) {
            Tally tally = each.getValue();
            models += tally.models;
            System.out.printf(
                    "%-34s %8d models, premise met %8d times, %d findings%n",
                    each.getKey().name(), tally.models, tally.met, tally.broken);
        }
        System.out.printf(
                "%d models in %.1f minutes, %.0f a minute; seed %d%n",
                models, minutes, models / minutes, seed);
    }
}

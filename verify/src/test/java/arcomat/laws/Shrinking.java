package arcomat.laws;

import arcomat.laws.Law.Outcome;
import arcomat.laws.draw.Smaller;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.Optional;

/** Makes models smaller for as long as they break the same law in the same way. */
final class Shrinking {
    private static final int MOST_TRIES = 20_000;

    private final Law law;
    private final int seed;
    private final String kind;
    private int tries;

    private Shrinking(Law law, int seed, String kind) {
        this.law = law;
        this.seed = seed;
        this.kind = kind;
    }

    /** What is left, and how it breaks the law. */
    record Smallest(List<SourceFile> files, Outcome outcome) {}

    static Smallest of(Law law, List<SourceFile> files, int seed, Outcome outcome) {
        Shrinking shrinking = new Shrinking(law, seed, kind(outcome));
        Smallest smallest = new Smallest(files, outcome);
        Optional<Smallest> next = Optional.of(smallest);
        while (next.isPresent() && shrinking.tries < MOST_TRIES) {
            smallest = next.get();
            next = shrinking.step(smallest.files);
        }
        return smallest;
    }

    /** The first words, without numbers and names. */
    static String kind(Outcome outcome) {
        return outcome.problem().replaceAll("[^a-z (].*", "");
    }

    private Optional<Smallest> step(List<SourceFile> files) {
        for (List<SourceFile> smaller : Smaller.than(files)) {
            tries++;
            Optional<Outcome> outcome = Trial.check(law, smaller, seed);
            if (outcome.filter(o -> o.isBroken() && kind(o).equals(kind)).isPresent()) {
                return Optional.of(new Smallest(smaller, outcome.get()));
            }
        }
        return Optional.empty();
    }
}

package arcomat.analysis;

import arcomat.analysis.RandomSketches.Knobs;
import arcomat.model.Automaton.Completion;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Function;

/**
 * Pairs of automata to compare: the right one is arbitrary, the left one is made from it by edits.
 * A good share is kept, a good share fails late. The same seed gives the same pairs.
 */
public final class RandomPairs {
    private static final List<Edit> MILD =
            List.of(Edit.DROP_ALTERNATIVE, Edit.COPY_STATE, Edit.ADD_LOOP, Edit.READ_EXTRA);
    private static final List<Edit> BOLD =
            List.of(
                    Edit.CHANGE_OUTPUT,
                    Edit.CHANGE_TARGET,
                    Edit.ADD_ALTERNATIVE,
                    Edit.DROP_ONLY,
                    Edit.ADD_MOVE);

    private RandomPairs() {}

    /**
     * Two automata.
     *
     * @param edits what leads from the right one to the left one
     */
    public record Pair(Sketch leftSketch, Sketch rightSketch, List<Edit> edits) {
        public Promise left() {
            return Promise.of(leftSketch.component("Left"), List.of());
        }

        public Promise right() {
            return Promise.of(rightSketch.component("Right"), List.of());
        }
    }

    /** Pairs with all sorts of ports, completions and densities. */
    public static List<Pair> any(long seed, int count) {
        return pairs(seed, count, RandomSketches::any);
    }

    /** Two promises. */
    public record Question(Promise left, Promise right) {}

    /** Pairs of conjunctions, each of two automata that leave much open. */
    public static List<Question> conjunctions(long seed, int count) {
        Random random = new Random(seed);
        List<Question> questions = new ArrayList<>();
        while (questions.size() < count) {
            Completion completion = random.nextInt(4) == 0 ? Completion.ERROR : Completion.OUTPUT;
            Knobs knobs = RandomSketches.any(random).withGaps(60).withCompletion(completion);
            Sketch first = RandomSketches.of(knobs, random);
            Sketch second = RandomSketches.of(knobs, random).withOpenings(first.openings());
            Pair one = pair(first, random);
            Pair two = pair(second, random);
            questions.add(
                    new Question(
                            promise(one.leftSketch, two.leftSketch, "Left"),
                            promise(one.rightSketch, two.rightSketch, "Right")));
        }
        return questions;
    }

    private static Promise promise(Sketch one, Sketch two, String name) {
        return Promise.of(Sketch.together(one, two, name), List.of());
    }

    /** Pairs of one sort. */
    static List<Pair> of(Knobs knobs, long seed, int count) {
        return pairs(seed, count, random -> knobs);
    }

    private static List<Pair> pairs(long seed, int count, Function<Random, Knobs> knobs) {
        Random random = new Random(seed);
        List<Pair> pairs = new ArrayList<>();
        while (pairs.size() < count) {
            pairs.add(pair(RandomSketches.of(knobs.apply(random), random), random));
        }
        return pairs;
    }

    private static Pair pair(Sketch right, Random random) {
        List<Edit> edits = new ArrayList<>();
        int mild = 1 + random.nextInt(3);
        for (int i = 0; i < mild; i++) {
            edits.add(MILD.get(random.nextInt(MILD.size())));
        }
        if (random.nextInt(5) > 0) {
            edits.add(BOLD.get(random.nextInt(BOLD.size())));
        }
        Sketch left = right;
        List<Edit> done = new ArrayList<>();
        for (Edit edit : edits) {
            Optional<Sketch> changed = edit.apply(left, random);
            if (changed.isPresent()) {
                left = changed.get();
                done.add(edit);
            }
        }
        if (random.nextInt(6) == 0 && !right.shape().totalOut()) {
            left = left.withCompletion(Completion.values()[random.nextInt(4)]);
        }
        return new Pair(left, right, done);
    }
}

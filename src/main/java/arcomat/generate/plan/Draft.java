package arcomat.generate.plan;

import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;

/**
 * What becomes of a composite in one order of its parts: which parts share an array, which messages
 * are copied when the slice starts and which right before the step of the receiver, and how much
 * code that takes, in bytes of a virtual machine, estimated from above.
 */
public final class Draft {
    static final int MOST_WEIGHT = 5000;
    private static final int PER_NODE = 40;
    private static final int PER_INPUT = 50;

    /** What a second visit of a part in a slice counts, in bytes of code. */
    private static final int PER_VISIT = 10;

    /** Construction happens once: a byte of it counts as that part of a byte of the steps. */
    private static final int ONCE = 10;

    /**
     * Parts of one component that follow each other and live in one array.
     *
     * @param field name of the array
     * @param first position of the first part in the composition
     * @param end position after the last part
     * @param merged whether a part gets every message as late as it may, right before its step
     */
    public record Stretch(String field, int first, int end, boolean merged) {
        /** The fewest parts for which an array reads better than fields. */
        static final int LEAST = 8;

        Stretch called(String name) {
            return new Stretch(name, first, end, merged);
        }

        public int length() {
            return end - first;
        }

        /** What its parts are called in the model. */
        public String comment(Composition composition) {
            List<Composition.Node> nodes = composition.nodes();
            return nodes.get(first).path()
                    + ", "
                    + nodes.get(first + 1).path()
                    + " .. "
                    + nodes.get(end - 1).path();
        }
    }

    private final Composition composition;
    private final IntPredicate sameArguments;
    private final int[] array;
    private final List<Stretch> stretches = new ArrayList<>();
    private final List<Integer> weights = new ArrayList<>();
    private final Regularity regularity;

    private Draft(Composition composition, IntPredicate sameArguments) {
        this.composition = composition;
        this.sameArguments = sameArguments;
        this.array = new int[composition.nodes().size()];
        Arrays.fill(array, -1);
        this.regularity = new Regularity(composition, node -> array[node]);
    }

    /**
     * Divides the parts.
     *
     * @param mayShare whether a node may live in an array
     * @param sameArguments whether a node has the arguments of the one before
     */
    static Draft of(Composition composition, IntPredicate mayShare, IntPredicate sameArguments) {
        Draft draft = new Draft(composition, sameArguments);
        draft.divide(mayShare);
        for (int i = 0; i < draft.stretches.size(); i++) {
            draft.settle(i);
        }
        return draft;
    }

    private void divide(IntPredicate mayShare) {
        Regularity guess = new Regularity(composition, this::numberOfComponent);
        int first = 0;
        int weight = 0;
        for (int node = 1; node <= array.length; node++) {
            boolean same =
                    node < array.length && mayShare.test(node) && name(node).equals(name(first));
            weight += same && sameArguments.test(node) && guess.follows(node) ? 0 : single(first);
            if (!same || weight > MOST_WEIGHT) {
                add(first, node, mayShare);
                first = node;
                weight = 0;
            }
        }
    }

    /** Until the arrays are known: as if each component had one. */
    private int numberOfComponent(int node) {
        return name(node).hashCode() & Integer.MAX_VALUE;
    }

    private String name(int node) {
        return composition.nodes().get(node).component().qualifiedName();
    }

    private void add(int first, int end, IntPredicate mayShare) {
        if (end - first >= Stretch.LEAST && mayShare.test(first)) {
            Arrays.fill(array, first, end, stretches.size());
            stretches.add(new Stretch("", first, end, true));
        }
    }

    /** Late copies join the loop of the steps, or spoil it. */
    private void settle(int number) {
        Stretch merged = stretches.get(number);
        int weightMerged = weight(merged);
        Stretch apart = new Stretch("", merged.first(), merged.end(), false);
        stretches.set(number, apart);
        int weightApart = weight(apart);
        if (weightMerged + visits(merged) <= weightApart + visits(apart)) {
            stretches.set(number, merged);
        }
        weights.add(Math.min(weightMerged, weightApart));
    }

    private int construction(Stretch stretch) {
        return PER_NODE * constructions(stretch).size();
    }

    /** Of the steps and the copies. */
    private int weight(Stretch stretch) {
        int weight = 0;
        for (Regularity.Run run : steps(stretch)) {
            weight += PER_NODE;
            for (int input = 0; input < inputs(run.first()); input++) {
                weight += isLate(stretch, run.first(), input) ? PER_INPUT : 0;
            }
        }
        for (int input = 0; input < inputs(stretch.first()); input++) {
            weight += PER_INPUT * early(stretch, input).size();
        }
        return weight;
    }

    private int visits(Stretch stretch) {
        int visits = 0;
        for (int node = stretch.first(); node < stretch.end(); node++) {
            for (int input = 0; input < inputs(node); input++) {
                visits += isEarly(stretch, node, input) ? PER_VISIT : 0;
            }
        }
        return visits;
    }

    private int inputs(int node) {
        return composition.nodes().get(node).inputs().size();
    }

    private int single(int node) {
        return PER_NODE + PER_INPUT * inputs(node);
    }

    private List<Regularity.Run> runs(
            Stretch stretch, Regularity.Choice choice, IntPredicate continues) {
        return regularity.runs(stretch.first(), stretch.end(), choice, continues);
    }

    /** The steps of the parts in an array, with the copies right before them. */
    public List<Regularity.Run> steps(Stretch stretch) {
        return runs(stretch, (node, input) -> isLate(stretch, node, input), node -> true);
    }

    /** The copies to an input of the parts in an array when the slice starts. */
    public List<Regularity.Run> early(Stretch stretch, int input) {
        return runs(
                        stretch,
                        (node, any) -> any == input && isEarly(stretch, node, any),
                        node -> true)
                .stream()
                .filter(run -> isEarly(stretch, run.first(), input))
                .toList();
    }

    /** Parts in an array that are constructed alike. */
    public List<Regularity.Run> constructions(Stretch stretch) {
        return runs(stretch, (node, input) -> false, sameArguments);
    }

    /**
     * Whether a message is copied right before the step: what is sent in the same slice has to be,
     * what was sent in the slice before can be as long as the sender has not taken its step.
     */
    public boolean isLate(Stretch stretch, int node, int input) {
        return composition
                .nodes()
                .get(node)
                .inputs()
                .get(input)
                .match(
                        outside -> stretch.merged(),
                        from -> from.fresh() || stretch.merged() && node <= from.node(),
                        () -> false);
    }

    private boolean isEarly(Stretch stretch, int node, int input) {
        Source source = composition.nodes().get(node).inputs().get(input);
        return !(source instanceof Source.Unconnected) && !isLate(stretch, node, input);
    }

    Composition composition() {
        return composition;
    }

    List<Stretch> stretches() {
        return stretches;
    }

    /** How much code there is; less is better. */
    long cost() {
        long cost = 0;
        for (int node = 0; node < array.length; node++) {
            cost += array[node] < 0 ? single(node) : 0;
        }
        for (int i = 0; i < stretches.size(); i++) {
            Stretch stretch = stretches.get(i);
            cost += weights.get(i) + visits(stretch) + construction(stretch) / ONCE;
        }
        return cost;
    }

    /** What has to stay together in a section: an array, or a part of its own. */
    List<Sections.Unit> units() {
        List<Sections.Unit> units = new ArrayList<>();
        for (int node = 0; node < array.length; ) {
            if (array[node] < 0) {
                units.add(new Sections.Unit(node, node + 1, single(node)));
            } else {
                Stretch stretch = stretches.get(array[node]);
                int weight = construction(stretch) + weights.get(array[node]);
                units.add(new Sections.Unit(stretch.first(), stretch.end(), weight));
            }
            node = units.get(units.size() - 1).end();
        }
        return units;
    }
}

package arcomat.analysis.search.packed;

import arcomat.analysis.search.composition.GlobalState;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * A network in numbers: configurations of parts, and what has been sent and can still be read, as
 * they are met. How many bits they take is known as far as they have been met; who meets more
 * widens the layout, and goes on in the new one.
 *
 * <p>The last field of a configuration is a mark, for who keeps it with something else.
 */
public abstract class PackedNetwork {
    /** Any odd number with many bits. */
    private static final long DIGEST = 0x9E3779B97F4A7C15L;

    /** What happens is more than tables can tell: only the unfolding knows. */
    public static final class CannotPack extends RuntimeException {
        private static final long serialVersionUID = 1L;

        public CannotPack(String reason) {
            super(reason, null, false, false);
        }
    }

    /** There are more values than the layout has bits for: it has to be widened. */
    public static final class TooNarrow extends RuntimeException {
        private static final long serialVersionUID = 1L;

        public TooNarrow() {
            super("the layout is too narrow", null, false, false);
        }
    }

    private int marks = 1;
    private int computed;

    /** Notes that something is computed, which is known from then on. */
    final void compute(Runnable between) {
        computed++;
        between.run();
    }

    /** Grows whenever what a part does is computed, which may be known from then on. */
    public final int computed() {
        return computed;
    }

    /** How many things have been met, by kind. */
    public abstract int[] met();

    /** One of them. */
    abstract Object thing(int kind, int number);

    /**
     * Whoever has met the same things in the same order has the same; nobody else, in practice.
     *
     * @param first so many things count, by kind
     */
    public final long digest(int[] first) {
        long digest = 0;
        for (int i = 0; i < first.length; i++) {
            for (int number = 0; number < first[i]; number++) {
                digest = digest * DIGEST + thing(i, number).toString().hashCode();
            }
        }
        return digest;
    }

    /** Gives room for so many marks. */
    public final void marks(int count) {
        marks = Math.max(marks, count);
    }

    /** With bits for all that has been met. */
    public abstract PackedLayout layout();

    /** Where the mark stands in a layout. */
    public abstract int markField();

    /** The bits of the mark. */
    final int markBits() {
        return bits(marks);
    }

    static int bits(int count) {
        return Integer.SIZE - Integer.numberOfLeadingZeros(Math.max(0, count - 1));
    }

    /** Per part those that are made of the same component. */
    static List<List<Integer>> alike(Network network) {
        Map<Component, List<Integer>> ofComponents = new IdentityHashMap<>();
        List<List<Integer>> alike = new ArrayList<>();
        for (Network.Instance instance : network.instances()) {
            List<Integer> same =
                    ofComponents.computeIfAbsent(instance.component(), c -> new ArrayList<>());
            same.add(alike.size());
            alike.add(same);
        }
        return alike;
    }

    /**
     * All that a configuration may do.
     *
     * @param layout of this network
     */
    public abstract PackedSteps steps(PackedLayout layout);

    /** A letter in numbers, for {@link PackedSteps#read}. */
    public abstract int[] letter(Value[] letter);

    /**
     * Writes a configuration down.
     *
     * @param into as many words as the layout has
     */
    public abstract void pack(GlobalState state, PackedLayout layout, long[] into);

    static void put(PackedLayout layout, long[] into, int field, int value) {
        if (!layout.fits(field, value)) {
            throw new TooNarrow();
        }
        layout.put(into, field, value);
    }

    public abstract GlobalState unpack(long[] from, PackedLayout layout);

    /** That of the configuration of the first part, which has number 0 where a run has ended. */
    static final List<Configuration> ENDED = List.of(Configuration.ERROR);

    /** Whether a run has ended here, in an error. */
    public abstract boolean hasEnded(long[] from, PackedLayout layout);

    /** Puts configurations of a layout into the form in which equal parts stand in one order. */
    public Consumer<long[]> canonical(PackedLayout layout) {
        return key -> {};
    }

    /** In words, which parts are equal; empty where none are. */
    public List<String> equalParts() {
        return List.of();
    }
}

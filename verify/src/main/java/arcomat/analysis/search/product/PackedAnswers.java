package arcomat.analysis.search.product;

import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.packed.PackedNetwork;
import arcomat.analysis.search.packed.PackedSteps;
import arcomat.analysis.search.step.CubeSplit;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.PackableSystem;

import com.carrotsearch.hppc.LongIntHashMap;
import com.carrotsearch.hppc.LongObjectHashMap;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntSupplier;

/**
 * What the right side of a packed search answers, in numbers: to each letter, and to each message
 * on compared outputs, once for all configurations of the left side that look alike at inputs.
 */
final class PackedAnswers {
    /**
     * How something that is sent is answered.
     *
     * @param next number of the set, by case; -1 where nothing can be forbidden any more, {@link
     *     #FAILS} where it is forbidden
     * @param messages how many are sent, by case
     */
    record Answer(int[] next, int[] messages) {}

    /** The letters for a way of looking at inputs, with what a set answers to each. */
    static final class Frame {
        private final Alphabet alphabet;

        /** By letter and external input. */
        final int[][] messages;

        private final Steps[] theirs;
        private final @Nullable Answer[][] answers;

        /** To what is sent rarely: by letter and by what is sent. */
        private final LongObjectHashMap<Answer> others = new LongObjectHashMap<>(2);

        Frame(Alphabet alphabet, int[][] messages, Steps[] theirs) {
            this.alphabet = alphabet;
            this.theirs = theirs;
            this.messages = messages;
            this.answers = new Answer[messages.length][0];
        }

        /** How many messages a letter takes. */
        int cost(int letter) {
            return alphabet.messages(letter);
        }

        private @Nullable Answer answer(int letter, int sent) {
            return sent < answers[letter].length
                    ? answers[letter][sent]
                    : others.get((long) letter << 32 | sent);
        }

        private void put(int letter, int sent, Answer answer) {
            if (sent < FEW) {
                int length = Math.max(sent + 1, answers[letter].length);
                answers[letter] = Arrays.copyOf(answers[letter], length);
                answers[letter][sent] = answer;
            } else {
                others.put((long) letter << 32 | sent, answer);
            }
        }
    }

    static final int FAILS = -2;

    /** Numbers of what is sent up to here have places, others are looked for. */
    private static final int FEW = 64;

    private final Product product;
    private final PackableSystem left;
    private final PackedNetwork network;
    private final BitSet sets = new BitSet();
    private LongIntHashMap sentByShown = new LongIntHashMap();
    private final List<LongObjectHashMap<Frame>> frames = new ArrayList<>();
    private final Map<Alphabet, int[][]> letters = new IdentityHashMap<>();
    private final Runnable whenSeveral;
    private boolean chaosReached;
    private boolean promising;
    private int computed;

    /**
     * @param whenSeveral called where the right side may be in several configurations at once,
     *     before that is told
     */
    PackedAnswers(
            Product product, PackableSystem left, PackedNetwork network, Runnable whenSeveral) {
        this.product = product;
        this.whenSeveral = whenSeveral;
        this.left = left;
        this.network = network;
    }

    /** In a new layout, what is shown has other numbers. */
    void forgetShown() {
        sentByShown = new LongIntHashMap();
    }

    /** Grows whenever an answer is computed, which is known from then on. */
    int computed() {
        return computed;
    }

    /** Whether the right side may be in chaos somewhere. */
    boolean chaosReached() {
        return chaosReached;
    }

    /** Whether the right side is not in chaos after some input. */
    boolean promising() {
        return promising;
    }

    /** How many sets of the right side have been met. */
    int sets() {
        return sets.cardinality();
    }

    /**
     * The letters that matter, with the answers of a set.
     *
     * @param looks how a configuration of the left side looks at inputs
     * @param configuration gives the number of that configuration
     * @throws PackedNetwork.CannotPack where messages are calculated with: then letters depend on
     *     what parts are in that read nothing from outside
     */
    Frame frame(int set, long looks, IntSupplier configuration) {
        while (frames.size() <= set) {
            frames.add(new LongObjectHashMap<>());
        }
        Frame known = frames.get(set).get(looks);
        if (known == null) {
            computed++;
            int left = configuration.getAsInt();
            if (product.calculates(left, set)) {
                throw new PackedNetwork.CannotPack("letters depend on more than looks tell");
            }
            Alphabet alphabet = product.alphabet(left, set);
            int[][] messages = messages(alphabet);
            Steps[] theirs = new Steps[messages.length];
            for (int letter = 0; letter < messages.length; letter++) {
                theirs[letter] = product.answers(set, alphabet, letter);
            }
            known = new Frame(alphabet, messages, theirs);
            frames.get(set).put(looks, known);
        }
        return known;
    }

    /** The letters in numbers, once for all sets with the same ones. */
    private int[][] messages(Alphabet alphabet) {
        int[][] known = letters.get(alphabet);
        if (known == null) {
            known = new int[alphabet.size()][];
            for (int letter = 0; letter < known.length; letter++) {
                known[letter] = network.letter(alphabet.letter(letter));
            }
            letters.put(alphabet, known);
        }
        return known;
    }

    /** The number of what is shown on compared outputs. */
    int sent(PackedSteps steps, long shown) {
        int slot = sentByShown.indexOf(shown);
        if (sentByShown.indexExists(slot)) {
            return sentByShown.indexGet(slot);
        }
        int sent = left.cube(signal -> steps.shown(shown, signal));
        sentByShown.put(shown, sent);
        return sent;
    }

    /** The answer to what is sent after a letter. */
    Answer answer(Frame frame, int letter, int sent) {
        Answer known = frame.answer(letter, sent);
        if (known == null) {
            computed++;
            known = answer(sent, frame.theirs[letter], false);
            frame.put(letter, sent, known);
        }
        return known;
    }

    /** The answer to what is sent before anything is read. */
    Answer atTheStart(int sent, Steps theirs) {
        return answer(sent, theirs, true);
    }

    private Answer answer(int sent, Steps theirs, boolean start) {
        List<CubeSplit.Case> cases = product.cases(sent, theirs);
        int[] next = new int[cases.size()];
        int[] messages = new int[cases.size()];
        for (int i = 0; i < next.length; i++) {
            int[] allowed = cases.get(i).allowed();
            messages[i] = cases.get(i).messages();
            next[i] = allowed.length == 0 ? FAILS : successor(theirs, allowed, start);
        }
        return new Answer(next, messages);
    }

    private int successor(Steps theirs, int[] allowed, boolean start) {
        int set = product.successor(theirs, allowed);
        if (set < 0) {
            chaosReached = true;
            return set;
        }
        if (product.sets.members(set).length > 1) {
            whenSeveral.run();
        }
        boolean chaos = product.isInChaos(set);
        chaosReached |= chaos;
        promising |= !start && !chaos;
        network.marks(set + 1);
        sets.set(set);
        return set;
    }
}

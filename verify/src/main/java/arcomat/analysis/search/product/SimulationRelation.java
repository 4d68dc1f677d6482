package arcomat.analysis.search.product;

import arcomat.analysis.search.Attractor;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.step.CubeSplit;
import arcomat.analysis.search.step.Steps;
import arcomat.semantics.value.GivenUp;

import com.carrotsearch.hppc.IntArrayList;
import com.carrotsearch.hppc.LongIntHashMap;
import com.carrotsearch.hppc.procedures.IntIntProcedure;

import java.util.Optional;

/**
 * Whether a configuration of the right side simulates one of the left side: every step of the left
 * is answered by one step of the right with the same output, for ever. Stronger than inclusion of
 * traces, and decided on pairs instead of sets. The greatest such relation: all pairs that can be
 * reached are taken to be related, until one has a step without an answer (on the fly, as a game:
 * Etessami, Wilke, Schuller, "Fair simulation relations, parity games, and state space reduction
 * for Büchi automata", 2005).
 *
 * <p>Pairs are explored as far as somebody has patience: there may be no end of them where the
 * search that asks would soon find a counterexample.
 */
final class SimulationRelation {
    private static final int MOST_PAIRS = 5_000_000;

    private final Product product;
    private final Budget budget;
    private final LongIntHashMap numbers = new LongIntHashMap();
    private final IntArrayList lefts = new IntArrayList();
    private final IntArrayList rights = new IntArrayList();
    private final Attractor refuted = new Attractor();
    private boolean exhausted;

    /** The first pair whose steps have not been looked at yet. */
    private int open;

    /** As many pairs have been explored to the end. */
    private int closed;

    /** Letters that have been looked at. */
    private long work;

    SimulationRelation(Product product, Budget budget) {
        this.product = product;
        this.budget = budget;
    }

    /**
     * False also where it was not decided within the budget.
     *
     * @param patience as many letters may be looked at, all that have been so far included
     */
    boolean holds(int left, int right, long patience) {
        if (exhausted) {
            return false;
        }
        int pair = pair(left, right);
        explore(pair, patience);
        return pair < closed && !refuted.isFallen(pair);
    }

    /** Tells all pairs that are known to be related: configurations of the left and right side. */
    void forEachPair(IntIntProcedure told) {
        for (int pair = 0; pair < closed; pair++) {
            if (!refuted.isFallen(pair)) {
                told.apply(lefts.get(pair), rights.get(pair));
            }
        }
    }

    /** For the whole: whether each beginning of the left has one of the right that simulates it. */
    Optional<Boolean> verdict() {
        Steps mine = product.left.openings();
        Steps theirs = product.right.openings();
        for (int step = 0; step < mine.size(); step++) {
            for (CubeSplit.Case sent : product.cases(mine.outputs()[step], theirs)) {
                boolean answered = false;
                for (int answer : sent.allowed()) {
                    int next = theirs.next()[answer];
                    answered |=
                            product.isSettled(next)
                                    || holds(mine.next()[step], next, Long.MAX_VALUE);
                }
                if (!answered) {
                    return exhausted ? Optional.empty() : Optional.of(false);
                }
            }
        }
        return Optional.of(true);
    }

    /** Until it is known whether the pair has fallen, or patience is lost. */
    private void explore(int pair, long patience) {
        try {
            while (open < lefts.size()
                    && !refuted.isFallen(pair)
                    && work < patience
                    && !exhausted) {
                exhausted = lefts.size() > MOST_PAIRS || budget.exhausted(lefts.size()) != null;
                if (!refuted.isFallen(open)) {
                    demand(open);
                }
                open++;
                refuted.propagate();
            }
        } catch (GivenUp inTheMiddle) {
            exhausted = true;
        }
        if (open == lefts.size() && !exhausted) {
            closed = open;
        }
    }

    private int pair(int left, int right) {
        long key = (long) left << 32 | right;
        int known = numbers.getOrDefault(key, -1);
        if (known < 0) {
            known = lefts.size();
            numbers.put(key, known);
            lefts.add(left);
            rights.add(right);
        }
        return known;
    }

    private void demand(int pair) {
        int left = lefts.get(pair);
        int right = rights.get(pair);
        int set = product.sets.singleton(right);
        Alphabet alphabet = product.alphabet(left, set);
        Steps[] own = product.leftSteps(left, alphabet);
        Steps[] other = product.rightSteps(set, right, alphabet);
        for (int letter = 0; letter < alphabet.size(); letter++) {
            work++;
            Steps mine = own[letter];
            Steps theirs = other[letter];
            for (int step = 0; step < mine.size(); step++) {
                for (CubeSplit.Case sent : product.cases(mine.outputs()[step], theirs)) {
                    if (!demand(pair, mine.next()[step], theirs, sent.allowed())) {
                        return;
                    }
                }
            }
        }
    }

    /**
     * False where nothing answers: then the pair has fallen, and its other demands do not matter.
     */
    private boolean demand(int owner, int left, Steps theirs, int[] allowed) {
        for (int answer : allowed) {
            if (product.isSettled(theirs.next()[answer])) {
                return true;
            }
        }
        int[] answers = new int[allowed.length];
        for (int i = 0; i < answers.length; i++) {
            answers[i] = pair(left, theirs.next()[allowed[i]]);
        }
        return refuted.demand(owner, answers);
    }
}

package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.step.CubeSplit;
import arcomat.analysis.search.step.Steps;
import arcomat.semantics.value.GivenUp;

import com.carrotsearch.hppc.IntArrayList;
import com.carrotsearch.hppc.LongIntHashMap;

import java.util.Optional;

/**
 * Whether a configuration of the right side simulates one of the left side: every step of the left
 * is answered by one step of the right with the same output, for ever. Stronger than inclusion of
 * traces, and decided on pairs instead of sets. The greatest such relation: all pairs that can be
 * reached are taken to be related, until one has a step without an answer.
 *
 * <p>Pairs are explored as far as somebody has patience: there may be no end of them where the
 * search that asks would soon find a counterexample.
 */
final class SimulationRelation {
    private static final int MOST_PAIRS = 5_000_000;
    private static final int NONE = -1;

    private final Product pairing;
    private final Budget budget;
    private final LongIntHashMap numbers = new LongIntHashMap();
    private final IntArrayList lefts = new IntArrayList();
    private final IntArrayList rights = new IntArrayList();
    private final java.util.BitSet refuted = new java.util.BitSet();

    /** Per pair a chain of the demands that it may answer: demand and next link. */
    private final IntArrayList firstLink = new IntArrayList();

    private final IntArrayList linkDemand = new IntArrayList();
    private final IntArrayList nextLink = new IntArrayList();

    private final IntArrayList demandOwner = new IntArrayList();
    private final IntArrayList demandAnswers = new IntArrayList();
    private final IntArrayList fallen = new IntArrayList();
    private boolean exhausted;

    /** The first pair whose steps have not been looked at yet. */
    private int open;

    /** As many pairs have been explored to the end. */
    private int closed;

    /** Letters that have been looked at. */
    private long work;

    SimulationRelation(Product pairing, Budget budget) {
        this.pairing = pairing;
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
        return pair < closed && !refuted.get(pair);
    }

    /** All pairs that are known to be related. */
    void forEachPair(PairVisitor visitor) {
        for (int pair = 0; pair < closed; pair++) {
            if (!refuted.get(pair)) {
                visitor.visit(lefts.get(pair), rights.get(pair));
            }
        }
    }

    /** Told of configurations of both sides. */
    interface PairVisitor {
        void visit(int left, int right);
    }

    /** For the whole: whether each beginning of the left has one of the right that simulates it. */
    Optional<Boolean> verdict() {
        Steps mine = pairing.left.openings();
        Steps theirs = pairing.right.openings();
        for (int step = 0; step < mine.size(); step++) {
            for (CubeSplit.Case sent : pairing.cases(mine.outputs()[step], theirs)) {
                boolean answered = false;
                for (int answer : sent.allowed()) {
                    int next = theirs.next()[answer];
                    answered |=
                            pairing.isSettled(next)
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
            while (open < lefts.size() && !refuted.get(pair) && work < patience && !exhausted) {
                exhausted = lefts.size() > MOST_PAIRS || budget.exhausted(lefts.size()) != null;
                if (!refuted.get(open)) {
                    demand(open);
                }
                open++;
                refute();
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
            firstLink.add(NONE);
        }
        return known;
    }

    private void demand(int pair) {
        int left = lefts.get(pair);
        int right = rights.get(pair);
        int set = pairing.sets.singleton(right);
        Alphabet alphabet = pairing.alphabet(left, set);
        Steps[] own = pairing.leftSteps(left, alphabet);
        Steps[] other = pairing.rightSteps(set, right, alphabet);
        for (int letter = 0; letter < alphabet.size(); letter++) {
            work++;
            Steps mine = own[letter];
            Steps theirs = other[letter];
            for (int step = 0; step < mine.size(); step++) {
                for (CubeSplit.Case sent : pairing.cases(mine.outputs()[step], theirs)) {
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
            if (pairing.isSettled(theirs.next()[answer])) {
                return true;
            }
        }
        int demand = demandOwner.size();
        int firstOfDemand = linkDemand.size();
        for (int answer : allowed) {
            int pair = pair(left, theirs.next()[answer]);
            if (!refuted.get(pair) && !isLinked(pair, firstOfDemand)) {
                linkDemand.add(demand);
                nextLink.add(firstLink.get(pair));
                firstLink.set(pair, linkDemand.size() - 1);
            }
        }
        if (linkDemand.size() == firstOfDemand) {
            fall(owner);
            return false;
        }
        demandOwner.add(owner);
        demandAnswers.add(linkDemand.size() - firstOfDemand);
        return true;
    }

    /** Whether a pair answers the demand whose links start there. */
    private boolean isLinked(int pair, int firstOfDemand) {
        return firstLink.get(pair) >= firstOfDemand;
    }

    private void fall(int pair) {
        if (!refuted.get(pair)) {
            refuted.set(pair);
            fallen.add(pair);
        }
    }

    private void refute() {
        while (!fallen.isEmpty()) {
            int link = firstLink.get(fallen.removeLast());
            while (link != NONE) {
                int demand = linkDemand.get(link);
                demandAnswers.set(demand, demandAnswers.get(demand) - 1);
                if (demandAnswers.get(demand) == 0) {
                    fall(demandOwner.get(demand));
                }
                link = nextLink.get(link);
            }
        }
    }
}

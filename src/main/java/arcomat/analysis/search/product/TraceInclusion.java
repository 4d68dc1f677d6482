package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.step.CubeSplit;
import arcomat.analysis.search.step.StepUnion;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.model.Trace;
import arcomat.semantics.value.GivenUp;

import com.carrotsearch.hppc.IntArrayList;
import com.carrotsearch.hppc.LongIntHashMap;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Whether every trace of the left side is one of the right side: breadth first over a configuration
 * of the left and all configurations that the right may be in (subset construction). A pair is left
 * out where the right may be in chaos and the left cannot err, where the right simulates the left,
 * or where a smaller set has been met with the same configuration (antichain).
 *
 * <p>The counterexample is shortest, and among those has fewest messages, and among those comes
 * first in the order of declaration.
 */
public final class TraceInclusion {
    private static final int NO_PARENT = -1;

    /** So many letters the question whether there is a simulation may take, whoever asks. */
    private static final long LITTLE_WORK = 300_000;

    /** Beyond that, so many times as many as the search itself has tried. */
    private static final long FACTOR = 8;

    private final Product pairing;
    private final Budget budget;
    private final SimulationRelation simulation;

    private final IntArrayList lefts = new IntArrayList();
    private final IntArrayList sets = new IntArrayList();
    private final IntArrayList parents = new IntArrayList();
    private final IntArrayList costs = new IntArrayList();
    private final LongIntHashMap nodes = new LongIntHashMap();
    private final Map<Integer, IntArrayList> largeSets = new HashMap<>();
    private boolean determined = true;
    private boolean chaosReached;
    private boolean promising;
    private Failure best;
    private final Map<Kind, Failure> failures = new LinkedHashMap<>();
    private boolean goesOn;
    private int level;
    private long tried;

    TraceInclusion(Product pairing, Budget budget) {
        this.pairing = pairing;
        this.budget = budget;
        this.simulation = new SimulationRelation(pairing, budget);
    }

    /**
     * What the search found.
     *
     * @param failure where the left side does what the right one forbids
     * @param stopped why the search ended before it was done
     * @param simulation whether the right side simulates the left one; empty where that was not
     *     decided
     * @param chaosReached whether some run is allowed only because the right side is in chaos
     * @param promising whether the right side is not in chaos after some input
     * @param pairs how many were explored
     */
    public record Result(
            Optional<Failure> failure,
            Optional<String> stopped,
            Optional<Boolean> simulation,
            boolean chaosReached,
            boolean promising,
            long pairs) {}

    /**
     * The forbidden step.
     *
     * @param node the pair before it, or {@link #NO_PARENT} for a forbidden beginning
     * @param step position among the left side's steps
     * @param level its number of inputs
     */
    public record Failure(
            int node,
            Alphabet alphabet,
            int letter,
            Steps steps,
            int step,
            CubeSplit.Case sent,
            int cost,
            int level) {}

    /** Failures are alike that do the same, or go wrong in doing the same. */
    private record Kind(List<Trace.Cause> causes, boolean error) {}

    /** Ends with the first failure. */
    Result search() {
        return search(false);
    }

    /**
     * @param on whether to go on behind failures, to find one for each cause
     */
    Result search(boolean on) {
        try {
            return levels(on);
        } catch (GivenUp inTheMiddle) {
            return result(Optional.of(inTheMiddle.getMessage()));
        }
    }

    private Result levels(boolean on) {
        goesOn = on;
        open();
        if (best != null && !on) {
            return result(Optional.empty());
        }
        int first = 0;
        while (first < lefts.size()) {
            int end = lefts.size();
            level++;
            Optional<String> exhausted = expandLevel(first, end);
            if (exhausted.isPresent()) {
                return result(exhausted);
            }
            if (best != null && !on) {
                return result(Optional.empty());
            }
            first = end;
        }
        return result(Optional.empty());
    }

    /** Pairs that took fewer messages first; in most levels all took the same. */
    private Optional<String> expandLevel(int first, int end) {
        int[] byCost = isEven(first, end) ? null : byCost(first, end);
        for (int i = first; i < end; i++) {
            String exhausted = budget.exhausted(lefts.size());
            if (exhausted != null) {
                return Optional.of(exhausted);
            }
            expand(byCost == null ? i : byCost[i - first], end);
        }
        return Optional.empty();
    }

    private boolean isEven(int first, int end) {
        for (int node = first + 1; node < end; node++) {
            if (costs.get(node) != costs.get(first)) {
                return false;
            }
        }
        return true;
    }

    private int[] byCost(int first, int end) {
        return IntStream.range(first, end)
                .boxed()
                .sorted(Comparator.comparingInt(costs::get))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    private Result result(Optional<String> stopped) {
        Optional<Boolean> simulated =
                stopped.isPresent()
                        ? Optional.empty()
                        : best != null
                                ? Optional.of(false)
                                : determined && budget.takes(Shortcut.DETERMINED)
                                        ? certain(true)
                                        : simulation.verdict().flatMap(this::certain);
        return new Result(
                Optional.ofNullable(best),
                stopped,
                simulated,
                chaosReached,
                promising,
                lefts.size());
    }

    /** Who decides late about a message simulates more easily, and is less easily simulated. */
    private Optional<Boolean> certain(boolean simulates) {
        TransitionSystem late = simulates ? pairing.right : pairing.left;
        return late.postpones() ? Optional.empty() : Optional.of(simulates);
    }

    private void open() {
        Steps mine = pairing.left.openings();
        Steps theirs = pairing.right.openings();
        for (int step = 0; step < mine.size(); step++) {
            for (CubeSplit.Case sent : pairing.cases(mine.outputs()[step], theirs)) {
                if (sent.allowed().length == 0) {
                    fail(new Failure(NO_PARENT, null, 0, mine, step, sent, sent.messages(), level));
                } else {
                    int set = successor(theirs, sent.allowed());
                    add(NO_PARENT, mine.next()[step], set, sent.messages(), 0);
                }
            }
        }
    }

    private void fail(Failure failure) {
        best = better(best, failure);
        if (goesOn) {
            List<Trace.Cause> causes = failure.steps.causes().get(failure.step);
            failures.merge(new Kind(causes, failure.sent.error()), failure, TraceInclusion::better);
        }
    }

    /** The shorter one, then that with fewer messages, then the one that was found first. */
    private static Failure better(Failure known, Failure found) {
        boolean cheaper = known != null && found.level == known.level && found.cost < known.cost;
        return known == null || cheaper ? found : known;
    }

    private void expand(int node, int levelEnd) {
        int left = lefts.get(node);
        int set = sets.get(node);
        Alphabet alphabet = pairing.alphabet(left, set);
        Steps[] own = pairing.leftSteps(left, alphabet);
        for (int letter = 0; letter < own.length; letter++) {
            Steps mine = own[letter];
            Steps theirs = answers(set, alphabet, letter);
            tried++;
            int cost = costs.get(node) + alphabet.messages(letter);
            for (int step = 0; step < mine.size(); step++) {
                mine.use(step);
                for (CubeSplit.Case sent : pairing.cases(mine.outputs()[step], theirs)) {
                    int total = cost + sent.messages();
                    if (sent.allowed().length == 0) {
                        fail(new Failure(node, alphabet, letter, mine, step, sent, total, level));
                    } else {
                        int next = successor(theirs, sent.allowed());
                        add(node, mine.next()[step], next, total, levelEnd);
                    }
                }
            }
        }
    }

    /** The steps of all members of a set. */
    Steps answers(int set, Alphabet alphabet, int letter) {
        int[] members = pairing.sets.members(set);
        if (members.length == 1) {
            return answers(set, members[0], alphabet, letter);
        }
        StepUnion union = new StepUnion();
        for (int member : members) {
            union.add(answers(set, member, alphabet, letter));
        }
        return union.steps();
    }

    Steps answers(int set, int member, Alphabet alphabet, int letter) {
        return pairing.rightSteps(set, member, alphabet)[letter];
    }

    /** The set after some of the steps; -1 where it holds chaos and nothing can be forbidden. */
    int successor(Steps theirs, int[] allowed) {
        if (allowed.length == 1) {
            theirs.use(allowed[0]);
            int next = theirs.next()[allowed[0]];
            return pairing.isSettled(next) ? -1 : pairing.sets.singleton(next);
        }
        int[] members = new int[allowed.length];
        for (int i = 0; i < members.length; i++) {
            budget.insist();
            theirs.use(allowed[i]);
            members[i] = theirs.next()[allowed[i]];
            if (pairing.isSettled(members[i])) {
                return -1;
            }
        }
        return pairing.sets.number(members);
    }

    private void add(int parent, int left, int set, int cost, int levelEnd) {
        if (set < 0) {
            chaosReached = true;
            return;
        }
        promising = promising || parent != NO_PARENT && !isInChaos(set);
        long key = (long) left << 32 | set;
        int slot = nodes.indexOf(key);
        if (nodes.indexExists(slot)) {
            int known = nodes.indexGet(slot);
            if (known >= levelEnd && cost < costs.get(known)) {
                costs.set(known, cost);
                parents.set(known, parent);
            }
            return;
        }
        chaosReached = chaosReached || isInChaos(set);
        if (pairing.sets.members(set).length > 1 && isCovered(left, set, cost, levelEnd)) {
            return;
        }
        nodes.indexInsert(slot, key, lefts.size());
        lefts.add(left);
        sets.add(set);
        parents.add(parent);
        costs.add(cost);
    }

    private boolean isInChaos(int set) {
        for (int member : pairing.sets.members(set)) {
            if (pairing.right.isChaos(member)) {
                return true;
            }
        }
        return false;
    }

    /** Whether a smaller set, or a member that simulates the configuration, settles the pair. */
    private boolean isCovered(int left, int set, int cost, int levelEnd) {
        determined = false;
        long patience = Math.max(LITTLE_WORK, FACTOR * tried);
        for (int member : pairing.sets.members(set)) {
            int alone = pairing.sets.singleton(member);
            if (isMet(left, alone, cost, levelEnd) && budget.takes(Shortcut.MET_ALONE)
                    || simulation.holds(left, member, patience)
                            && budget.takes(Shortcut.SIMULATED)) {
                return true;
            }
        }
        IntArrayList met = largeSets.computeIfAbsent(left, each -> new IntArrayList());
        for (int i = 0; i < met.size(); i++) {
            if (pairing.sets.isSubset(met.get(i), set)
                    && isMet(left, met.get(i), cost, levelEnd)
                    && budget.takes(Shortcut.MET_SMALLER)) {
                return true;
            }
        }
        met.add(set);
        return false;
    }

    /**
     * Whether a pair has been met after fewer inputs, or after as many and no more messages:
     * otherwise a failure behind it is not the one that is looked for.
     */
    private boolean isMet(int left, int set, int cost, int levelEnd) {
        int node = nodes.getOrDefault((long) left << 32 | set, NO_PARENT);
        return node != NO_PARENT && (node < levelEnd || costs.get(node) <= cost);
    }

    /** The pairs that show the inclusion, of a search that ended without failure. */
    Certificate certificate() {
        List<Certificate.Entry> entries = new ArrayList<>();
        for (int node = 0; node < lefts.size(); node++) {
            List<String> right = new ArrayList<>();
            for (int member : pairing.sets.members(sets.get(node))) {
                right.add(pairing.right.name(member));
            }
            entries.add(new Certificate.Entry(pairing.left.name(lefts.get(node)), right));
        }
        simulation.forEachPair(
                (left, right) ->
                        entries.add(
                                new Certificate.Entry(
                                        pairing.left.name(left),
                                        List.of(pairing.right.name(right)))));
        return new Certificate(entries.stream().distinct().toList());
    }

    /** The pairs from a beginning to a node. */
    List<Integer> path(int node) {
        List<Integer> path = new ArrayList<>();
        for (int each = node; each != NO_PARENT; each = parents.get(each)) {
            path.add(0, each);
        }
        return path;
    }

    int left(int node) {
        return lefts.get(node);
    }

    int set(int node) {
        return sets.get(node);
    }

    int cost(int node) {
        return costs.get(node);
    }

    long pairs() {
        return lefts.size();
    }

    /** One failure for each cause of a forbidden step, the shortest. */
    List<Failure> failures() {
        return List.copyOf(failures.values());
    }
}

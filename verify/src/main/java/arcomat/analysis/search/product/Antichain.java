package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.MacroStates;
import arcomat.analysis.search.Shortcut;

import com.carrotsearch.hppc.IntArrayList;
import com.carrotsearch.hppc.LongIntHashMap;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The pairs of a configuration and a macro state that a search has met, level by level. A pair is
 * left out where a smaller set has been met with the same configuration: what the smaller one
 * allows for ever, the larger one does (De Wulf, Doyen, Henzinger, Raskin, "Antichains: a new
 * algorithm for checking universality of finite automata", CAV 2006); and where a member of the set
 * simulates the configuration (Abdulla, Chen, Holík, Mayr, Vojnar, "When simulation meets
 * antichains", TACAS 2010). Neither where that would cost a shorter counterexample, or one with
 * fewer messages.
 */
final class Antichain {
    /** In place of the pair before a beginning. */
    static final int NONE = -1;

    private final MacroStates macroStates;
    private final SimulationRelation simulation;
    private final Budget budget;
    private final IntArrayList lefts = new IntArrayList();
    private final IntArrayList sets = new IntArrayList();
    private final IntArrayList parents = new IntArrayList();
    private final IntArrayList costs = new IntArrayList();
    private final LongIntHashMap nodes = new LongIntHashMap();
    private final Map<Integer, IntArrayList> largeSets = new HashMap<>();
    private boolean determined = true;

    /** The first pair of the level that is being found. */
    private int levelStart;

    Antichain(MacroStates macroStates, SimulationRelation simulation, Budget budget) {
        this.macroStates = macroStates;
        this.simulation = simulation;
        this.budget = budget;
    }

    /**
     * Ends a level.
     *
     * @return its pairs, those that took fewer messages first
     */
    int[] nextLevel() {
        int[] level = Frontier.byCost(costs, levelStart);
        levelStart = lefts.size();
        return level;
    }

    /**
     * Adds a pair, unless it need not be looked at.
     *
     * @param parent the pair before it, or {@link #NONE}
     * @param cost how many messages led to it
     * @param patience for the question whether there is a simulation
     * @return whether the pair itself was not met before
     */
    boolean add(int parent, int left, int set, int cost, long patience) {
        long key = (long) left << 32 | set;
        int slot = nodes.indexOf(key);
        if (nodes.indexExists(slot)) {
            int known = nodes.indexGet(slot);
            if (known >= levelStart && cost < costs.get(known)) {
                costs.set(known, cost);
                parents.set(known, parent);
            }
            return false;
        }
        if (macroStates.members(set).length == 1 || !isCovered(left, set, cost, patience)) {
            nodes.indexInsert(slot, key, lefts.size());
            lefts.add(left);
            sets.add(set);
            parents.add(parent);
            costs.add(cost);
        }
        return true;
    }

    /** Whether a smaller set, or a member that simulates the configuration, settles the pair. */
    private boolean isCovered(int left, int set, int cost, long patience) {
        determined = false;
        for (int member : macroStates.members(set)) {
            int alone = macroStates.singleton(member);
            if (isMet(left, alone, cost) && budget.takes(Shortcut.MET_ALONE)
                    || simulation.holds(left, member, patience)
                            && budget.takes(Shortcut.SIMULATED)) {
                return true;
            }
        }
        IntArrayList met = largeSets.computeIfAbsent(left, each -> new IntArrayList());
        for (int i = 0; i < met.size(); i++) {
            if (macroStates.isSubset(met.get(i), set)
                    && isMet(left, met.get(i), cost)
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
    private boolean isMet(int left, int set, int cost) {
        int node = nodes.getOrDefault((long) left << 32 | set, NONE);
        return node != NONE && (node < levelStart || costs.get(node) <= cost);
    }

    /** Whether every set that was met has one member. */
    boolean isDetermined() {
        return determined;
    }

    /** The pairs from a beginning to a node. */
    List<Integer> path(int node) {
        List<Integer> path = new ArrayList<>();
        for (int each = node; each != NONE; each = parents.get(each)) {
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

    int size() {
        return lefts.size();
    }
}

package arcomat.analysis.search;

import com.carrotsearch.hppc.IntArrayList;

import java.util.BitSet;

/**
 * From where an opponent can enforce a win: a node falls when one of its demands has no answer left
 * that stands. Each answer is looked at twice only, when its demand is made and when it falls (Liu,
 * Smolka, "Simple linear-time algorithms for minimal fixed points", ICALP 1998). What stands in the
 * end is the greatest simulation, or the winning region of a safety game.
 */
public final class Attractor {
    private static final int NONE = -1;

    private final BitSet fallen = new BitSet();
    private final IntArrayList open = new IntArrayList();

    /** Per node a chain of the demands that it may answer: demand and next link. */
    private final IntArrayList firstLink = new IntArrayList();

    private final IntArrayList linkDemand = new IntArrayList();
    private final IntArrayList nextLink = new IntArrayList();
    private final IntArrayList demandOwner = new IntArrayList();
    private final IntArrayList demandAnswers = new IntArrayList();

    public boolean isFallen(int node) {
        return fallen.get(node);
    }

    /** All that have fallen. */
    public BitSet fallen() {
        return (BitSet) fallen.clone();
    }

    /**
     * The owner stands only as long as one of the answers does.
     *
     * @return false where none of them stands: then the owner has fallen
     */
    public boolean demand(int owner, int[] answers) {
        int demand = demandOwner.size();
        int firstOfDemand = linkDemand.size();
        for (int answer : answers) {
            while (firstLink.size() <= answer) {
                firstLink.add(NONE);
            }
            boolean linked = firstLink.get(answer) >= firstOfDemand;
            if (!linked && !fallen.get(answer)) {
                linkDemand.add(demand);
                nextLink.add(firstLink.get(answer));
                firstLink.set(answer, linkDemand.size() - 1);
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

    /** A node falls for itself. */
    public void fall(int node) {
        if (!fallen.get(node)) {
            fallen.set(node);
            open.add(node);
        }
    }

    /** Lets all fall that have a demand without an answer. */
    public void propagate() {
        while (!open.isEmpty()) {
            int node = open.removeLast();
            int link = node < firstLink.size() ? firstLink.get(node) : NONE;
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

package arcomat.analysis.search.packed;

/** The failure that is told: of those that took fewest messages, the first. */
public final class CheapestFailure {
    private long pair;
    private int cost;

    /** None so far. */
    public CheapestFailure() {
        this(PairStore.NONE, 0);
    }

    /** As far as it was known before. */
    public CheapestFailure(long pair, int cost) {
        this.pair = pair;
        this.cost = cost;
    }

    /** A step from a pair fails. */
    public void add(long from, int messages) {
        if (!isFound() || messages < cost) {
            pair = from;
            cost = messages;
        }
    }

    public boolean isFound() {
        return pair != PairStore.NONE;
    }

    /** The pair from which a step fails; {@link PairStore#NONE} where none does. */
    public long pair() {
        return pair;
    }

    /** The messages on the way to it, those of the step included. */
    public int cost() {
        return cost;
    }
}

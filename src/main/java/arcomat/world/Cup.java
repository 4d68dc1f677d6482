package arcomat.world;

/** What a fetcher has in its holder. */
public enum Cup {
    NONE(0),
    EMPTY(10),
    FULL(200);

    /** In grams. */
    final double mass;

    Cup(double mass) {
        this.mass = mass;
    }
}

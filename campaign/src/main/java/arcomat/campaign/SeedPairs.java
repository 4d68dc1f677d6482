package arcomat.campaign;

import arcomat.campaign.statistics.McNemar;

/**
 * Which way seeds went whose pairs differ. Pairs of one seed, at different points of a grid, have
 * their chance in common: each seed speaks once, for what most of its pairs say. If the two words
 * do not differ, it is as likely to say the one as the other, so that McNemar's test goes on as it
 * is.
 */
public final class SeedPairs {
    private long seed;
    private long balance;
    private long better;
    private long worse;

    /**
     * The next pair that differs; those of one seed come one after the other.
     *
     * @param change 1 if it got better, -1 if worse
     */
    public void add(long seed, int change) {
        if (seed != this.seed) {
            better += balance > 0 ? 1 : 0;
            worse += balance < 0 ? 1 : 0;
            this.seed = seed;
            balance = 0;
        }
        balance += change;
    }

    /** Of all seeds so far. */
    public McNemar test() {
        return new McNemar(better + (balance > 0 ? 1 : 0), worse + (balance < 0 ? 1 : 0));
    }
}

package arcomat.campaign.statistics;

/**
 * The numbers from 0 to {@code size} in an order drawn by chance, where the place of one can be had
 * without those of the others: the swap-or-not shuffle (Hoang, Morris, Rogaway: An enciphering
 * scheme based on a card shuffle, CRYPTO 2012). In each round every number has a partner, and a
 * coin per pair says whether the two change places.
 */
record Shuffle(Draws draws, long size) {
    /** That many for each bit of the size mix well, says the paper. */
    private static final int ROUNDS_PER_BIT = 6;

    /** For sizes of one and two, too. */
    private static final int LEAST_ROUNDS = 24;

    /** Where {@code number} goes; each number goes somewhere else. */
    long place(long number) {
        long place = number;
        for (int i = 0; i < rounds(); i++) {
            Draws round = draws.part(i);
            long partner = Math.floorMod(round.below(size) - place, size);
            if (round.part(Math.max(place, partner)).bits() < 0) {
                place = partner;
            }
        }
        return place;
    }

    private int rounds() {
        return LEAST_ROUNDS + ROUNDS_PER_BIT * (Long.SIZE - Long.numberOfLeadingZeros(size));
    }
}

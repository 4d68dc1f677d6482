package arcomat.world;

import arcomat.world.Seeds.Change;

/**
 * Numbers drawn from seeds, each by what it is for and not by when it is asked: a robot more in a
 * world changes nothing for the others.
 */
final class Chance {
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;
    private static final int PARTS = 4;
    private static final double PART = 0x10000;

    /** Of what is drawn once, before the first step. */
    static final long ONCE = -1;

    private final Seeds seeds;

    Chance(Seeds seeds) {
        this.seeds = seeds;
    }

    /**
     * About normal, of mean 0 and deviation 1, never beyond 3.5.
     *
     * @param moment a step of the world, or {@link #ONCE}
     */
    double normal(long subject, long purpose, long moment) {
        long bits = mix(drawn(seedAt(moment), subject, purpose) + moment * GOLDEN);
        double sum = 0;
        for (int i = 0; i < PARTS; i++) {
            sum += (bits & 0xFFFF) / PART - 0.5;
            bits >>>= 16;
        }
        return sum * Math.sqrt(12.0 / PARTS);
    }

    /** Even, from 0 to 1; drawn once. */
    double even(long subject, long purpose) {
        return (mix(drawn(seeds.first(), subject, purpose)) >>> 11) * 0x1.0p-53;
    }

    private static long drawn(long seed, long subject, long purpose) {
        return mix(mix(seed + GOLDEN) + subject * GOLDEN + purpose);
    }

    private long seedAt(long moment) {
        long seed = seeds.first();
        for (Change change : seeds.changes()) {
            if (moment < change.tick()) {
                break;
            }
            seed = change.seed();
        }
        return seed;
    }

    /** The finishing steps of SplitMix64. */
    private static long mix(long bits) {
        long mixed = (bits ^ bits >>> 30) * 0xBF58476D1CE4E5B9L;
        mixed = (mixed ^ mixed >>> 27) * 0x94D049BB133111EBL;
        return mixed ^ mixed >>> 31;
    }
}

package arcomat.world;

/**
 * Numbers drawn from a seed, each by what it is for and not by when it is asked: a robot more in a
 * world changes nothing for the others.
 */
final class Chance {
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;
    private static final int PARTS = 4;
    private static final double PART = 0x10000;

    private final long seed;

    Chance(long seed) {
        this.seed = seed;
    }

    /** About normal, of mean 0 and deviation 1, never beyond 3.5. */
    double normal(long subject, long purpose, long moment) {
        long bits = mix(mix(mix(seed + GOLDEN) + subject * GOLDEN + purpose) + moment * GOLDEN);
        double sum = 0;
        for (int i = 0; i < PARTS; i++) {
            sum += (bits & 0xFFFF) / PART - 0.5;
            bits >>>= 16;
        }
        return sum * Math.sqrt(12.0 / PARTS);
    }

    /** Even, from 0 to 1. */
    double even(long subject, long purpose) {
        return (mix(mix(mix(seed + GOLDEN) + subject * GOLDEN + purpose)) >>> 11) * 0x1.0p-53;
    }

    /** The finishing steps of SplitMix64. */
    private static long mix(long bits) {
        long mixed = (bits ^ bits >>> 30) * 0xBF58476D1CE4E5B9L;
        mixed = (mixed ^ mixed >>> 27) * 0x94D049BB133111EBL;
        return mixed ^ mixed >>> 31;
    }
}

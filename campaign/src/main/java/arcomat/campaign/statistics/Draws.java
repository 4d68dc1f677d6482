package arcomat.campaign.statistics;

/**
 * Numbers that look as if drawn by chance, each by its name and not by when it is asked: the parts
 * of {@code Draws.of(seed)} are told apart by numbers, and their parts again. By the finishing
 * steps of SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA
 * 2014).
 */
record Draws(long key) {
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;

    /** So that nothing is drawn here as it is drawn in a world of the same seed. */
    private static final long SALT = 0x5851F42D4C957F2DL;

    static Draws of(long seed) {
        return new Draws(mix(seed ^ SALT));
    }

    Draws part(long number) {
        return new Draws(mix(key + (number + 1) * GOLDEN));
    }

    /** 64 of them, each set or not. */
    long bits() {
        return mix(key);
    }

    /** Even, from 0 to 1, the end excluded. */
    double even() {
        return (bits() >>> 11) * 0x1.0p-53;
    }

    /** Even, from 0 to {@code count}, the end excluded; {@code count} is far below 2^63. */
    long below(long count) {
        return Math.floorMod(bits(), count);
    }

    /** Normal, of mean 0 and deviation 1 (Box, Muller 1958). */
    double normal() {
        double radius = StrictMath.sqrt(-2 * StrictMath.log(1 - part(0).even()));
        return radius * StrictMath.cos(2 * StrictMath.PI * part(1).even());
    }

    private static long mix(long bits) {
        long mixed = (bits ^ bits >>> 30) * 0xBF58476D1CE4E5B9L;
        mixed = (mixed ^ mixed >>> 27) * 0x94D049BB133111EBL;
        return mixed ^ mixed >>> 31;
    }
}

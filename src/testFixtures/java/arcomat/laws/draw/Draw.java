package arcomat.laws.draw;

import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;

/** Draws from a seed, as far as the features go. */
public final class Draw {
    private final Random random;
    private final Set<Features> features;

    public Draw(long seed, Set<Features> features) {
        this(new Random(seed), features);
    }

    private Draw(Random random, Set<Features> features) {
        this.random = random;
        this.features = features;
    }

    /** The same, but for one feature. */
    Draw without(Features feature) {
        Set<Features> fewer = new HashSet<>(features);
        fewer.remove(feature);
        return new Draw(random, fewer);
    }

    public boolean has(Features feature) {
        return features.contains(feature);
    }

    public boolean chance(int percent) {
        return random.nextInt(100) < percent;
    }

    /** By chance, and only where the feature is wanted. */
    boolean chance(Features feature, int percent) {
        return chance(percent) && has(feature);
    }

    /** From 0, the bound excluded. */
    public int below(int bound) {
        return random.nextInt(bound);
    }

    @SafeVarargs
    public final <T> T one(T... of) {
        return of[random.nextInt(of.length)];
    }

    public <T> T one(List<T> of) {
        return of.get(random.nextInt(of.size()));
    }
}

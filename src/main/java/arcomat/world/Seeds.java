package arcomat.world;

import java.util.ArrayList;
import java.util.List;

/**
 * Seeds of what is drawn in a run. The first one draws what is drawn once, when the world begins:
 * places, wheels, offsets of sensors. What is drawn from moment to moment, the errors of readings,
 * may be drawn by other seeds from some moments on. So runs can have their beginning in common, to
 * the bit, and go apart later.
 *
 * @param changes in the order of time
 */
public record Seeds(long first, List<Change> changes) {
    public Seeds {
        changes = List.copyOf(changes);
        for (int i = 1; i < changes.size(); i++) {
            if (changes.get(i).tick() <= changes.get(i - 1).tick()) {
                throw new IllegalArgumentException("not in the order of time: " + changes);
            }
        }
    }

    /**
     * From a moment on, another seed draws.
     *
     * @param tick the first step of the world, of {@value Physics#STEP} ms each, that it draws for
     */
    public record Change(long tick, long seed) {
        public Change {
            if (tick < 0) {
                throw new IllegalArgumentException("before the beginning: " + tick);
            }
        }
    }

    /** One seed draws everything. */
    public static Seeds of(long seed) {
        return new Seeds(seed, List.of());
    }

    /** The same up to a moment after all changes, and another seed from then on. */
    public Seeds then(long tick, long seed) {
        List<Change> more = new ArrayList<>(changes);
        more.add(new Change(tick, seed));
        return new Seeds(first, more);
    }
}

package arcomat.world;

import java.math.BigDecimal;
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

        /** With the moment in seconds: {@code 12.5=77}. */
        public String text() {
            BigDecimal seconds = BigDecimal.valueOf(tick * Physics.STEP, 3);
            return seconds.stripTrailingZeros().toPlainString() + "=" + seed;
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

    /** The same up to a moment, and another seed from then on, instead of what there was. */
    public Seeds afresh(long tick, long seed) {
        List<Change> before = changes.stream().filter(each -> each.tick() < tick).toList();
        return new Seeds(first, before).then(tick, seed);
    }

    /** As tables write it: {@code 5}, or {@code 5@12.5=77} where 77 draws from 12.5 s on. */
    public String text() {
        StringBuilder text = new StringBuilder().append(first);
        changes.forEach(each -> text.append('@').append(each.text()));
        return text.toString();
    }

    /**
     * What {@link #text} has written.
     *
     * @throws IllegalArgumentException where it is something else
     */
    public static Seeds parse(String text) {
        String[] parts = text.split("@", -1);
        Seeds seeds = of(Long.parseLong(parts[0]));
        for (int i = 1; i < parts.length; i++) {
            String[] change = parts[i].split("=", 2);
            if (change.length < 2) {
                throw new IllegalArgumentException(text);
            }
            seeds = seeds.then(tick(change[0]), Long.parseLong(change[1]));
        }
        return seeds;
    }

    private static long tick(String seconds) {
        try {
            BigDecimal milliseconds = new BigDecimal(seconds).movePointRight(3);
            return milliseconds.longValueExact() / Physics.STEP;
        } catch (ArithmeticException e) {
            throw new IllegalArgumentException(seconds, e);
        }
    }
}

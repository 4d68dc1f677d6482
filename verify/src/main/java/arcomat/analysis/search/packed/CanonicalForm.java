package arcomat.analysis.search.packed;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Puts groups of equal fields into one order: sorted, or, in a ring, beginning where what follows
 * is least. What differs in nothing but their places is the same afterwards.
 */
final class CanonicalForm {
    /** Neighbours in a word that stay neighbours. */
    private record Segment(int word, int shift, long mask, int place) {}

    private final boolean ring;
    private final Segment[][] segments;

    /** Bits of all groups, by word. */
    private final long[] all;

    private final long[] groups;
    private final long[] sorted;

    /**
     * @param fields by group, those of each as many and as wide as those of the others; a group
     *     takes no more than one word
     */
    CanonicalForm(boolean ring, List<int[]> fields, PackedLayout layout) {
        this.ring = ring;
        segments = new Segment[fields.size()][];
        all = new long[layout.words()];
        groups = new long[fields.size()];
        sorted = new long[fields.size()];
        for (int group = 0; group < segments.length; group++) {
            segments[group] = segments(fields.get(group), layout);
            for (Segment each : segments[group]) {
                all[each.word] |= each.mask << each.shift;
            }
        }
    }

    /** Whether groups of fields fit into words. */
    static boolean fits(int[] fields, PackedLayout layout) {
        return Arrays.stream(fields).map(layout::width).sum() < Long.SIZE;
    }

    private static Segment[] segments(int[] fields, PackedLayout layout) {
        List<Segment> segments = new ArrayList<>();
        int place = 0;
        for (int field : fields) {
            int width = layout.width(field);
            if (width == 0) {
                continue;
            }
            Segment last = segments.isEmpty() ? null : segments.get(segments.size() - 1);
            int lastWidth = last == null ? 0 : Long.bitCount(last.mask);
            if (last != null
                    && last.word == layout.word(field)
                    && last.shift + lastWidth == layout.shift(field)) {
                long mask = (1L << lastWidth + width) - 1;
                Segment longer = new Segment(last.word, last.shift, mask, last.place);
                segments.set(segments.size() - 1, longer);
            } else {
                long mask = (1L << width) - 1;
                segments.add(new Segment(layout.word(field), layout.shift(field), mask, place));
            }
            place += width;
        }
        return segments.toArray(Segment[]::new);
    }

    /** Changes a configuration into the one that stands for it. */
    void apply(long[] key) {
        for (int group = 0; group < groups.length; group++) {
            long bits = 0;
            for (Segment each : segments[group]) {
                bits |= (key[each.word] >>> each.shift & each.mask) << each.place;
            }
            groups[group] = bits;
        }
        if (ring ? !rotate() : !sort()) {
            return;
        }
        for (int word = 0; word < all.length; word++) {
            key[word] &= ~all[word];
        }
        for (int group = 0; group < sorted.length; group++) {
            for (Segment each : segments[group]) {
                key[each.word] |= (sorted[group] >>> each.place & each.mask) << each.shift;
            }
        }
    }

    private boolean sort() {
        System.arraycopy(groups, 0, sorted, 0, groups.length);
        Arrays.sort(sorted);
        return !Arrays.equals(sorted, groups);
    }

    private boolean rotate() {
        int start = least();
        for (int i = 0; i < groups.length; i++) {
            sorted[i] = groups[(start + i) % groups.length];
        }
        return start != 0;
    }

    /** Where the least rotation begins: of two beginnings, the greater one is given up. */
    private int least() {
        int length = groups.length;
        int one = 0;
        int other = 1;
        int same = 0;
        while (one < length && other < length && same < length) {
            int comparison =
                    Long.compare(groups[(one + same) % length], groups[(other + same) % length]);
            if (comparison == 0) {
                same++;
                continue;
            }
            if (comparison > 0) {
                one += same + 1;
            } else {
                other += same + 1;
            }
            other += one == other ? 1 : 0;
            same = 0;
        }
        return Math.min(one, other);
    }
}

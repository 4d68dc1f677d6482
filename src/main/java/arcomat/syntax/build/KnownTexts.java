package arcomat.syntax.build;

import arcomat.source.Span;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * The texts of names and literals of one file, equal ones once. They are looked up where they
 * stand: most are known, and would be copied only to be thrown away. A table with open addressing
 * (Knuth, The Art of Computer Programming 3, 6.4, algorithm L).
 */
final class KnownTexts {
    private final String file;
    private @Nullable String[] slots = new String[256];
    private int count;

    KnownTexts(String file) {
        this.file = file;
    }

    String of(Span span) {
        int slot = slot(span.start(), span.end());
        String known = slots[slot];
        return known == null ? add(slot, span.text()) : known;
    }

    /** Where the text is, or the free place that is to have it. */
    private int slot(int start, int end) {
        int length = end - start;
        int slot = mixed(hash(start, end)) & slots.length - 1;
        for (String known = slots[slot]; known != null; known = slots[slot]) {
            if (known.length() == length && file.startsWith(known, start)) {
                return slot;
            }
            slot = slot + 1 & slots.length - 1;
        }
        return slot;
    }

    /** As that of strings. */
    private int hash(int start, int end) {
        int hash = 0;
        for (int i = start; i < end; i++) {
            hash = 31 * hash + file.charAt(i);
        }
        return hash;
    }

    private static int mixed(int hash) {
        return hash ^ hash >>> 16;
    }

    private String add(int slot, String text) {
        slots[slot] = text;
        count++;
        if (count * 2 > slots.length) {
            grow();
        }
        return text;
    }

    private void grow() {
        String[] old = slots;
        slots = new String[old.length * 2];
        Arrays.stream(old).filter(text -> text != null).forEach(this::settle);
    }

    private void settle(String text) {
        int slot = mixed(text.hashCode()) & slots.length - 1;
        while (slots[slot] != null) {
            slot = slot + 1 & slots.length - 1;
        }
        slots[slot] = text;
    }
}

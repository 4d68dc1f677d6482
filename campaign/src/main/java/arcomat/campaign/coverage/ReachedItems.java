package arcomat.campaign.coverage;

import java.util.BitSet;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * The coverage items that one run has come to, by their numbers in {@link CoverageItems}.
 *
 * @param text {@code x} and hexadecimal digits: the first tells of the numbers 0 to 3, 0 by its
 *     lowest bit; digits 0 at the end are left out. Empty where nobody knows. The letter keeps
 *     programs that read tables from taking it for a number
 */
public record ReachedItems(String text) {
    private static final Pattern FORM = Pattern.compile("|x([0-9a-f]*[1-9a-f])?");
    private static final String BEGIN = "x";
    private static final int BITS = 4;
    private static final int BASE = 1 << BITS;

    /** Of a run whose programs have no models, or that was not made. */
    public static final ReachedItems UNKNOWN = new ReachedItems("");

    /**
     * @throws IllegalArgumentException where it is no such text
     */
    public ReachedItems {
        if (!FORM.matcher(text).matches()) {
            throw new IllegalArgumentException(text);
        }
    }

    public static ReachedItems of(BitSet numbers) {
        StringBuilder text = new StringBuilder(BEGIN);
        for (int first = 0; first < numbers.length(); first += BITS) {
            int digit = 0;
            for (int bit = 0; bit < BITS; bit++) {
                digit |= numbers.get(first + bit) ? 1 << bit : 0;
            }
            text.append(Character.forDigit(digit, BASE));
        }
        return new ReachedItems(text.toString());
    }

    public boolean isKnown() {
        return !text.isEmpty();
    }

    public boolean contains(int number) {
        int place = BEGIN.length() + number / BITS;
        return place < text.length()
                && (Character.digit(text.charAt(place), BASE) >> number % BITS & 1) == 1;
    }

    /** How many of the numbers from 0 to less than an end it has. */
    public int countBelow(int end) {
        return (int) IntStream.range(0, end).filter(this::contains).count();
    }
}

package arcomat.source;

import java.util.Collection;
import java.util.Locale;
import java.util.Optional;

/** Finds the name that was probably meant. */
public final class Nearest {
    /** Comparing with very many names would cost more than a guess is worth. */
    private static final int MOST_CANDIDATES = 2_000;

    private Nearest() {}

    /**
     * The candidate that a name was most likely meant to be; empty if none is close or two are
     * equally close. Close is: one edit in three letters, letter case aside. No element of an array
     * is meant by another one.
     */
    public static Optional<String> to(String name, Collection<String> candidates) {
        if (candidates.size() > MOST_CANDIDATES || ArrayNames.hint(name, candidates).isPresent()) {
            return Optional.empty();
        }
        String best = null;
        int bestEdits = Math.max(1, name.length() / 3) + 1;
        boolean unique = true;
        for (String candidate : candidates) {
            int edits = edits(name, candidate, bestEdits);
            if (candidate.equals(name) || candidate.equals(best) || edits > bestEdits) {
                continue;
            }
            unique = edits < bestEdits;
            if (unique) {
                best = candidate;
                bestEdits = edits;
            }
        }
        return unique ? Optional.ofNullable(best) : Optional.empty();
    }

    /** {@code "; did you mean 'x'?"}, what there is of an array, or nothing. */
    public static String hint(String name, Collection<String> candidates) {
        Optional<String> ofArray = ArrayNames.hint(name, candidates);
        if (ofArray.isPresent()) {
            return ofArray.get();
        }
        return to(name, candidates).map(n -> "; did you mean '" + n + "'?").orElse("");
    }

    /** A single letter is no evidence of another one. */
    private static int edits(String name, String candidate, int limit) {
        String a = name.toLowerCase(Locale.ROOT);
        String b = candidate.toLowerCase(Locale.ROOT);
        boolean tooShort = Math.min(a.length(), b.length()) < 2 && !a.equals(b);
        return tooShort || Math.abs(a.length() - b.length()) > limit ? limit + 1 : edits(a, b);
    }

    /**
     * Edits that turn one word into another: insert, delete, replace a letter, swap two neighbours
     * (the optimal string alignment distance).
     */
    private static int edits(String a, String b) {
        int[][] rows = new int[a.length() + 1][b.length() + 1];
        for (int i = 0; i <= a.length(); i++) {
            for (int j = 0; j <= b.length(); j++) {
                rows[i][j] = i == 0 || j == 0 ? i + j : cell(rows, a, b, i, j);
            }
        }
        return rows[a.length()][b.length()];
    }

    private static int cell(int[][] rows, String a, String b, int i, int j) {
        int replaced = rows[i - 1][j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
        int best = Math.min(replaced, 1 + Math.min(rows[i - 1][j], rows[i][j - 1]));
        boolean swapped =
                i > 1
                        && j > 1
                        && a.charAt(i - 1) == b.charAt(j - 2)
                        && a.charAt(i - 2) == b.charAt(j - 1);
        return swapped ? Math.min(best, rows[i - 2][j - 2] + 1) : best;
    }
}

package arcomat.check;

import java.util.Collection;
import java.util.Locale;
import java.util.Optional;

/** Guesses what a misspelled name was meant to be. */
final class Spelling {
    private Spelling() {}

    /**
     * The candidate that a name was most likely meant to be; empty if none is close or two are
     * equally close. Close is: one edit in three letters, letter case aside.
     */
    static Optional<String> nearest(String name, Collection<String> candidates) {
        String best = null;
        int bestDistance = Math.max(1, name.length() / 3) + 1;
        boolean unique = true;
        for (String candidate : candidates) {
            int distance = distance(lower(name), lower(candidate), bestDistance);
            if (candidate.equals(name) || candidate.equals(best) || distance > bestDistance) {
                continue;
            }
            unique = distance < bestDistance;
            if (unique) {
                best = candidate;
                bestDistance = distance;
            }
        }
        return unique ? Optional.ofNullable(best) : Optional.empty();
    }

    private static String lower(String text) {
        return text.toLowerCase(Locale.ROOT);
    }

    /**
     * Edits that turn one word into another: insert, delete, replace a letter, swap two neighbours
     * (the optimal string alignment distance); any number above the limit stands for "too many".
     */
    private static int distance(String a, String b, int limit) {
        if (Math.abs(a.length() - b.length()) > limit) {
            return limit + 1;
        }
        int[][] rows = new int[a.length() + 1][b.length() + 1];
        for (int i = 0; i <= a.length(); i++) {
            for (int j = 0; j <= b.length(); j++) {
                rows[i][j] = cell(rows, a, b, i, j);
            }
        }
        return rows[a.length()][b.length()];
    }

    private static int cell(int[][] rows, String a, String b, int i, int j) {
        if (i == 0 || j == 0) {
            return i + j;
        }
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

package arcomat.pipeline.explored;

import arcomat.source.Sha256;

import java.util.Locale;

/**
 * The name of a promise among files: some of its words, for who looks into the folder, and a digest
 * of all of them, since file systems cut names, and take capital letters for small ones.
 *
 * @param title in words, as long as they may be
 * @param number which one of that title, from 1
 */
record PromiseName(String title, int number) {
    private static final int MOST_LETTERS = 48;
    private static final int DIGITS = 24;

    String asFile() {
        String words =
                title.toLowerCase(Locale.ROOT)
                        .replaceAll("[^a-z0-9]+", "-")
                        .replaceAll("^-|-$", "");
        String digest = Sha256.hex(number + " " + title).substring(0, DIGITS);
        return words.substring(0, Math.min(MOST_LETTERS, words.length())) + "-" + digest;
    }
}

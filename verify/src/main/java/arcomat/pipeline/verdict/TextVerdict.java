package arcomat.pipeline.verdict;

import java.util.function.Supplier;

/**
 * What is known about a place in a text.
 *
 * @param text in a line
 * @param sheet all that there is to be said
 */
public record TextVerdict(VerdictPlace place, Tone tone, String text, Sheet sheet) {
    /** How good the news is. */
    public enum Tone {
        /** There is nothing more to be done. */
        GOOD,
        /** Something is wrong, and the sheet says what. */
        BAD,
        /** Nobody knows, or there is something to be looked at. */
        OPEN
    }

    /**
     * Something to be looked at.
     *
     * @param file the name of a file for it, by whose end everybody knows what is in it
     * @param content made only when somebody wants to look, since pictures take a while
     */
    public record Sheet(String file, Supplier<String> content) {}
}

package arcomat.report.page;

import java.util.List;

/**
 * A report. All texts of it are plain text, whatever they look like.
 *
 * @param command what was asked, such as {@code simulate}
 * @param title what it was asked about
 * @param headline what came of it, in a sentence
 * @param stories runs, the first one is shown first
 */
public record Page(String command, String title, Tone tone, String headline, List<Story> stories) {
    public Page {
        stories = List.copyOf(stories);
    }

    /** How good news is. */
    public enum Tone {
        GOOD,
        BAD,
        OPEN,
        NEUTRAL
    }
}

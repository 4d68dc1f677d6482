package arcomat.pipeline.campaign;

import java.util.Optional;

/**
 * What a table answers, kept beside it: the campaign's text, which says what the columns mean.
 *
 * @param hash of the campaign with all that its rows depend on
 * @param text as its author wrote it
 */
record AskedCampaign(String hash, String text) {
    /** Its name, beside the table. */
    static final String FILE = "rows.campaign";

    private static final String HEAD = "# campaign ";

    /** Still the text of a campaign: what comes first is a comment. */
    String content() {
        return HEAD + hash + "\n" + text;
    }

    /** Empty where it is no such file. */
    static Optional<AskedCampaign> of(String content) {
        int end = content.indexOf('\n');
        return content.startsWith(HEAD) && end > 0
                ? Optional.of(
                        new AskedCampaign(
                                content.substring(HEAD.length(), end), content.substring(end + 1)))
                : Optional.empty();
    }
}

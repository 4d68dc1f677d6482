package arcomat.campaign.statistics;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * A table of a page that a test writes when it is told to, and compares otherwise.
 *
 * @param heading the first line of the table
 */
record PageTable(Path page, String heading) {
    private static final boolean UPDATE = Boolean.getBoolean("transcripts.update");

    void assertRows(List<String> rows) throws IOException {
        String text = Files.readString(page);
        assertThat(text).contains(heading);
        int begin = text.indexOf('\n', text.indexOf(heading) + heading.length() + 1) + 1;
        int blank = text.indexOf("\n\n", begin - 1);
        int end = blank < 0 ? text.length() : blank + 1;
        String table = String.join("\n", rows) + "\n";
        if (UPDATE) {
            Files.writeString(page, text.substring(0, begin) + table + text.substring(end));
        }
        assertThat(text.substring(begin, end)).isEqualTo(table);
    }
}

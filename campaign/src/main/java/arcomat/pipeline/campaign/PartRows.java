package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.Row;
import arcomat.campaign.TableText;
import arcomat.campaign.Trial;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** The rows that one part of a campaign has made, asked for in the order of their numbers. */
final class PartRows implements AutoCloseable {
    private final BufferedReader reader;
    private final TableText text;
    private Optional<Row> next = Optional.empty();

    private PartRows(BufferedReader reader, TableText text) throws IOException {
        this.reader = reader;
        this.text = text;
        reader.readLine(); // whose they are
        advance();
    }

    /** What stands in a file that has these runs of a campaign. */
    static String owner(String hash, long first, long end) {
        return "%s from %d to %d".formatted(hash, first, end);
    }

    /** Whether a file has rows of a part of this campaign. */
    static boolean isOf(String hash, Path file) throws IOException {
        return RowFile.owner(file).startsWith(hash + " from ");
    }

    static PartRows of(Path file, Campaign campaign) throws IOException {
        return new PartRows(Files.newBufferedReader(file), new TableText(campaign));
    }

    private void advance() throws IOException {
        next = Optional.ofNullable(reader.readLine()).map(text::row);
    }

    /**
     * The row of a trial, if it is here.
     *
     * @param trial its number is greater than all that were asked for
     */
    Optional<Row> row(Trial trial) throws IOException {
        while (next.isPresent() && next.get().trial().number() < trial.number()) {
            advance();
        }
        return next.filter(row -> row.trial().equals(trial));
    }

    @Override
    public void close() throws IOException {
        reader.close();
    }
}

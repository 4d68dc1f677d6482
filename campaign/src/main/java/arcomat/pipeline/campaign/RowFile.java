package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.Row;
import arcomat.campaign.TableText;
import arcomat.source.Sha256;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * The rows of a campaign in a file, in the order of their numbers, from the first on without a gap:
 * what has been written is safe if the process is killed, but for a line that is not whole. The
 * first line says to which campaign they belong.
 */
final class RowFile implements AutoCloseable {
    private static final String HEAD = "# campaign ";

    private final Path file;
    private final Campaign campaign;
    private final TableText text;
    private final MessageDigest digest = Sha256.begin();
    private final BufferedWriter writer;
    private long count;

    private RowFile(Path file, Campaign campaign, TableText text, BufferedWriter writer) {
        this.file = file;
        this.campaign = campaign;
        this.text = text;
        this.writer = writer;
        digest(text.header());
    }

    /** A new file, instead of what may have been there. */
    static RowFile create(Path file, Campaign campaign, String hash) throws IOException {
        BufferedWriter writer = Files.newBufferedWriter(file);
        writer.write(HEAD + hash + "\n");
        writer.flush();
        return new RowFile(file, campaign, new TableText(campaign), writer);
    }

    /** The campaign that the rows of a file belong to; empty where it is no such file. */
    static String owner(Path file) throws IOException {
        try (Stream<String> lines = Files.lines(file)) {
            return lines.findFirst()
                    .filter(line -> line.startsWith(HEAD))
                    .map(line -> line.substring(HEAD.length()))
                    .orElse("");
        }
    }

    /**
     * Goes on with a file.
     *
     * @param seen is shown the rows that are there, in order
     */
    static RowFile resume(Path file, Campaign campaign, Consumer<Row> seen) throws IOException {
        cutUnfinishedLine(file);
        BufferedWriter writer =
                Files.newBufferedWriter(file, StandardCharsets.UTF_8, StandardOpenOption.APPEND);
        RowFile rows = new RowFile(file, campaign, new TableText(campaign), writer);
        try (Stream<String> lines = Files.lines(file)) {
            lines.skip(1)
                    .forEach(
                            line -> {
                                rows.digest(line);
                                rows.count++;
                                seen.accept(rows.text.row(line));
                            });
        }
        return rows;
    }

    /** A line that a killed process has not finished is no row. */
    private static void cutUnfinishedLine(Path file) throws IOException {
        try (var channel =
                Files.newByteChannel(file, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
            ByteBuffer one = ByteBuffer.allocate(1);
            long end = channel.size();
            while (end > 0) {
                channel.position(end - 1);
                one.clear();
                channel.read(one);
                if (one.get(0) == '\n') {
                    break;
                }
                end--;
            }
            channel.truncate(end);
        }
    }

    /** The campaign whose rows these are. */
    Campaign campaign() {
        return campaign;
    }

    /** How many rows there are. */
    long count() {
        return count;
    }

    /** Adds the next rows. */
    void add(Iterable<Row> rows) throws IOException {
        for (Row row : rows) {
            String line = text.line(row);
            digest(line);
            writer.write(line);
            writer.write('\n');
            count++;
        }
        writer.flush();
    }

    private void digest(String line) {
        digest.update(line.getBytes(StandardCharsets.UTF_8));
        digest.update((byte) '\n');
    }

    /** What tells this table from any other: 16 hexadecimal digits of a SHA-256. */
    String hash() {
        try {
            byte[] all = ((MessageDigest) digest.clone()).digest();
            return HexFormat.of().formatHex(all, 0, 8);
        } catch (CloneNotSupportedException e) {
            throw new AssertionError("the digest of the JDK can be copied", e);
        }
    }

    /** The numbers of each measure, to be read often; to be closed. */
    ColumnFiles columns() throws IOException {
        try (Stream<Row> all = rows()) {
            return ColumnFiles.of(campaign, all);
        }
    }

    /** All rows, read from the file; to be closed. */
    Stream<Row> rows() {
        return lines().map(text::row);
    }

    /** The table as it is given to people: with names, without the campaign. */
    Stream<String> table() {
        return Stream.concat(Stream.of(text.header()), lines());
    }

    @SuppressWarnings("StreamResourceLeak") // whoever asks closes it
    private Stream<String> lines() {
        try {
            return Files.lines(file).skip(1);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void close() throws IOException {
        writer.close();
    }
}

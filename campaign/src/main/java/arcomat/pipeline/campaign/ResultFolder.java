package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.Row;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.parquet.ParquetTable;
import arcomat.pipeline.file.AtomicFile;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Iterator;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * Where the rows of a campaign are kept: while it runs, in a file that another run can go on with;
 * then as the finished table. Who wants no table has a folder of its own that is removed.
 */
final class ResultFolder implements AutoCloseable {
    static final String TABLE = "rows.csv";
    static final String TYPED = "rows.parquet";
    private static final String UNFINISHED = "rows.unfinished";
    private static final String PART = "rows.part";

    private final Path folder;
    private final String written;

    private ResultFolder(Path folder, String written) {
        this.folder = folder;
        this.written = written;
    }

    /**
     * @param written as the user wrote it; empty for one that nobody wants to see
     */
    static ResultFolder of(String written, PathNames names) throws IOException {
        if (written.isEmpty()) {
            return new ResultFolder(Files.createTempDirectory("arcomat-campaign"), written);
        }
        return new ResultFolder(Files.createDirectories(names.resolve(written)), written);
    }

    private Path unfinished() {
        return folder.resolve(UNFINISHED);
    }

    /**
     * The file of rows to go on with, or a new one.
     *
     * @param hash of the campaign with all that it depends on; of a part, with its runs
     * @param seen is shown the rows that are there already
     */
    RowFile rows(Campaign campaign, String hash, boolean resumes, Consumer<Row> seen)
            throws IOException, WrongUse {
        if (!Files.exists(unfinished())) {
            return RowFile.create(unfinished(), campaign, hash);
        }
        if (!resumes) {
            throw new WrongUse(
                    "'%s' has rows of a campaign that has not come to its end: go on with --resume,"
                            + " or remove %s there",
                    written, UNFINISHED);
        }
        if (!RowFile.owner(unfinished()).equals(hash)) {
            throw new WrongUse(
                    "the rows in '%s' belong to another campaign, part, world, program or version"
                            + " of the tool; remove %s there to begin anew",
                    written, UNFINISHED);
        }
        return RowFile.resume(unfinished(), campaign, seen);
    }

    /** All runs of a part have been made. */
    void keepPart() throws IOException {
        Files.move(unfinished(), folder.resolve(PART), StandardCopyOption.REPLACE_EXISTING);
    }

    /**
     * The rows of a part that has been made.
     *
     * @param written the folder, as the user wrote it
     * @param hash of the campaign with all that it depends on
     * @throws WrongUse where there is none, or one of something else
     */
    static Path part(String written, String hash, PathNames names) throws IOException, WrongUse {
        Path folder = names.resolve(written);
        Path part = folder.resolve(PART);
        if (!Files.exists(part) && isTableOf(hash, folder)) {
            return folder.resolve(TABLE);
        }
        if (!Files.exists(part)) {
            throw new WrongUse(
                    Files.exists(folder.resolve(UNFINISHED))
                            ? "the part in '%s' has not come to its end: go on with it by --part"
                                    + " and --resume"
                            : "there is no part of a campaign in '%s', which --part writes",
                    written);
        }
        if (!PartRows.isOf(hash, part)) {
            throw new WrongUse(
                    "the part in '%s' belongs to another campaign, world, program or version of the"
                            + " tool",
                    written);
        }
        return part;
    }

    /** A finished table serves as a part that has all runs. */
    private static boolean isTableOf(String hash, Path folder) throws IOException {
        Path asked = folder.resolve(AskedCampaign.FILE);
        return Files.exists(folder.resolve(TABLE))
                && Files.exists(asked)
                && AskedCampaign.of(Files.readString(asked))
                        .filter(each -> each.hash().equals(hash))
                        .isPresent();
    }

    /**
     * The campaign is over: its table takes the place of an older one.
     *
     * @param asked what the campaign asks, for who finds its table later
     */
    void keep(RowFile rows, AskedCampaign asked) throws IOException {
        if (written.isEmpty()) {
            return;
        }
        AtomicFile.write(folder.resolve(AskedCampaign.FILE), asked.content());
        Path fresh = folder.resolve(TABLE + ".new");
        try (var writer = Files.newBufferedWriter(fresh);
                Stream<String> lines = rows.table()) {
            for (Iterator<String> each = lines.iterator(); each.hasNext(); ) {
                writer.write(each.next());
                writer.write('\n');
            }
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
        Files.move(fresh, folder.resolve(TABLE), StandardCopyOption.REPLACE_EXISTING);
        keepTyped(rows);
        Files.delete(unfinished());
    }

    private void keepTyped(RowFile rows) throws IOException {
        Path fresh = folder.resolve(TYPED + ".new");
        try (Stream<Row> all = rows.rows()) {
            ParquetTable.write(fresh, rows.campaign(), all);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
        Files.move(fresh, folder.resolve(TYPED), StandardCopyOption.REPLACE_EXISTING);
    }

    @Override
    public void close() throws IOException {
        if (written.isEmpty()) {
            Files.deleteIfExists(unfinished());
            Files.delete(folder);
        }
    }
}

package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.Column;
import arcomat.campaign.Row;
import arcomat.campaign.statistics.Measurements;

import java.io.BufferedOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.stream.Stream;

/**
 * The numbers of each measure of a table, a file for each. A quantile reads them several times:
 * from the table's text, all of them together took longer than the runs.
 */
final class ColumnFiles implements AutoCloseable {
    private final Campaign campaign;
    private final Path folder;

    private ColumnFiles(Campaign campaign, Path folder) {
        this.campaign = campaign;
        this.folder = folder;
    }

    /**
     * Reads the rows once.
     *
     * @param rows all of them; those that were not made have no numbers
     */
    static ColumnFiles of(Campaign campaign, Stream<Row> rows) throws IOException {
        ColumnFiles files = new ColumnFiles(campaign, Files.createTempDirectory("arcomat-columns"));
        try {
            files.write(rows);
        } catch (IOException | RuntimeException e) {
            files.close();
            throw e;
        }
        return files;
    }

    private void write(Stream<Row> rows) throws IOException {
        List<Target> targets = new ArrayList<>();
        try {
            for (int place : places()) {
                targets.add(new Target(place, file(place)));
            }
            for (Iterator<Row> each = rows.filter(Row::wasMade).iterator(); each.hasNext(); ) {
                Row row = each.next();
                for (Target target : targets) {
                    target.add(row);
                }
            }
        } finally {
            for (Target target : targets) {
                target.close();
            }
        }
    }

    /** Of the measures: events are counted. */
    private List<Integer> places() {
        return campaign.columns().stream()
                .filter(column -> !column.isEvent())
                .map(Column::name)
                .map(campaign::column)
                .toList();
    }

    private Path file(int place) {
        return folder.resolve(place + ".numbers");
    }

    /** The numbers of a measure, of the rows that were made; those that are none are left out. */
    Measurements measured(String column) {
        Path file = file(campaign.column(column));
        return Measurements.of(() -> NumberFile.stream(file));
    }

    @Override
    public void close() throws IOException {
        for (int place : places()) {
            Files.deleteIfExists(file(place));
        }
        Files.deleteIfExists(folder);
    }

    /** A file that is written. */
    private static final class Target implements AutoCloseable {
        private final int place;
        private final DataOutputStream out;

        Target(int place, Path file) throws IOException {
            this.place = place;
            this.out = new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(file)));
        }

        void add(Row row) throws IOException {
            double number = row.answer(place);
            if (!Double.isNaN(number)) {
                out.writeDouble(number);
            }
        }

        @Override
        public void close() throws IOException {
            out.close();
        }
    }
}

package arcomat.pipeline.campaign.parquet;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.campaign.Column;
import arcomat.campaign.Row;
import arcomat.campaign.Row.Ending;
import arcomat.campaign.Trial;
import arcomat.campaign.coverage.ReachedItems;
import arcomat.source.SourceFile;

import blue.strategic.parquet.Hydrator;
import blue.strategic.parquet.HydratorSupplier;
import blue.strategic.parquet.ParquetReader;

import org.apache.parquet.format.ColumnChunk;
import org.apache.parquet.format.FileMetaData;
import org.apache.parquet.format.Util;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/** A table is read again as it was written: types, what is unknown, and every row. */
class ParquetTableTest {
    private static final Campaign CAMPAIGN =
            CampaignParser.parse(
                            new SourceFile(
                                    "c",
                                    "world w\nvary light from 0 to 4\nvary steps of 1 2.5\n"
                                            + "vary driver of old new\n"
                                            + "vary time from 1 to 9 whole\nsample random 10\n"))
                    .campaign()
                    .orElseThrow();

    @TempDir private Path folder;

    private static Row row(long number) {
        Trial trial =
                new Trial(
                        number,
                        number + 7,
                        Map.of(
                                "light",
                                number + ".25",
                                "steps",
                                "2.5",
                                "driver",
                                "new",
                                "time",
                                "8"));
        if (number % 3 == 2) {
            return Row.withoutAnswers(trial, Ending.IMPOSSIBLE, "line 1: no");
        }
        List<Double> answers = new ArrayList<>();
        for (Column column : CAMPAIGN.columns()) {
            answers.add(column.isEvent() ? number % 2 : number / 8.0);
        }
        answers.set(CAMPAIGN.column("reached"), Double.POSITIVE_INFINITY);
        answers.set(CAMPAIGN.column("distance"), Double.NaN);
        answers.set(CAMPAIGN.column("goal"), Double.NaN);
        return number % 2 == 0
                ? Row.made(trial, answers)
                : Row.made(trial, answers, new ReachedItems("x07"));
    }

    /** Else the bytes would be other ones in another process. */
    @Test
    void theFooterListsEncodingsInTheOrderOfTheirNumbers() throws IOException {
        Path file = write("ordered.parquet", 100);
        byte[] all = Files.readAllBytes(file);
        int length = ByteBuffer.wrap(all).order(ByteOrder.LITTLE_ENDIAN).getInt(all.length - 8);
        int start = all.length - 8 - length;
        FileMetaData footer = Util.readFileMetaData(new ByteArrayInputStream(all, start, length));
        for (ColumnChunk column : footer.getRow_groups().get(0).getColumns()) {
            assertThat(column.getMeta_data().getEncodings()).hasSizeGreaterThan(1).isSorted();
        }
    }

    private Path write(String name, long rows) throws IOException {
        Path file = folder.resolve(name);
        try (Stream<Row> all = LongStream.range(0, rows).mapToObj(ParquetTableTest::row)) {
            ParquetTable.write(file, CAMPAIGN, all);
        }
        return file;
    }

    private static List<Map<String, Object>> read(Path file) throws IOException {
        HydratorSupplier<Map<String, Object>, Map<String, Object>> asMap =
                HydratorSupplier.constantly(
                        new Hydrator<>() {
                            @Override
                            public Map<String, Object> start() {
                                return new TreeMap<>();
                            }

                            @Override
                            public Map<String, Object> add(
                                    Map<String, Object> row, String column, Object value) {
                                if (value != null) {
                                    row.put(column, value);
                                }
                                return row;
                            }

                            @Override
                            public Map<String, Object> finish(Map<String, Object> row) {
                                return row;
                            }
                        });
        try (Stream<Map<String, Object>> rows = ParquetReader.streamContent(file.toFile(), asMap)) {
            return rows.toList();
        }
    }

    @Test
    void cellsHaveTypes() throws IOException {
        List<Map<String, Object>> rows = read(write("rows.parquet", 2));
        assertThat(rows.get(0)).doesNotContainKey("taken");
        Map<String, Object> row = rows.get(1);
        assertThat(row)
                .containsEntry("run", 1L)
                .containsEntry("seed", 8L)
                .containsEntry("light", 1.25)
                .containsEntry("steps", 2.5)
                .containsEntry("driver", "new")
                .containsEntry("ending", "made")
                .containsEntry("collision", true)
                .containsEntry("parameter time", 8.0)
                .containsEntry("time", 0.125)
                .containsEntry("reached", Double.POSITIVE_INFINITY)
                .containsEntry("taken", "x07")
                .doesNotContainKeys("distance", "goal");
    }

    @Test
    void aRunThatWasNotMadeHasNoAnswers() throws IOException {
        assertThat(read(write("rows.parquet", 3)).get(2))
                .containsOnlyKeys(
                        "run", "seed", "light", "steps", "driver", "parameter time", "ending")
                .containsEntry("ending", "impossible: line 1: no");
    }

    @Tag("slow")
    @Test
    void manyRowsStayInOrder() throws IOException {
        long rows = 100_000; // more than are written together
        assertThat(read(write("rows.parquet", rows)))
                .extracting(row -> row.get("run"))
                .containsExactlyElementsOf(LongStream.range(0, rows).boxed().toList());
    }

    @Test
    void theSameRowsAreTheSameBytes() throws IOException {
        assertThat(write("a.parquet", 1000)).hasSameBinaryContentAs(write("b.parquet", 1000));
        assertThat(Files.list(folder)).hasSize(2); // no file of checksums beside it
    }
}

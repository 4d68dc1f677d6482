package arcomat.pipeline.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.campaign.Column;
import arcomat.campaign.Row;
import arcomat.campaign.Row.Ending;
import arcomat.campaign.Trial;
import arcomat.campaign.statistics.Measurements;
import arcomat.campaign.statistics.Quantile;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.util.Map;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/** Numbers of measures come back as they were, more of them than are read at once. */
class ColumnFilesTest {
    private static final Campaign CAMPAIGN =
            CampaignParser.parse(new SourceFile("c", "world w\nsample random 10\n"))
                    .campaign()
                    .orElseThrow();

    private static Row row(long number) {
        Trial trial = new Trial(number, number, Map.of());
        if (number % 5 == 4) {
            return Row.withoutAnswers(trial, Ending.GIVEN_UP, "too long");
        }
        return Row.made(
                trial, CAMPAIGN.columns().stream().map(column -> answer(column, number)).toList());
    }

    private static double answer(Column column, long number) {
        return switch (column.name()) {
            case "reached" -> Double.POSITIVE_INFINITY;
            case "distance" -> Double.NaN;
            default -> number;
        };
    }

    private static ColumnFiles columns(long rows) throws IOException {
        try (Stream<Row> all = LongStream.range(0, rows).mapToObj(ColumnFilesTest::row)) {
            return ColumnFiles.of(CAMPAIGN, all);
        }
    }

    @Test
    void allNumbersAreReadAsOftenAsOneLikes() throws IOException {
        try (ColumnFiles columns = columns(100_000)) {
            Measurements time = columns.measured("time");
            assertThat(time.size()).isEqualTo(80_000);
            assertThat(new Quantile(0.5).estimate(time)).isEqualTo(49_998);
            assertThat(time.share(number -> number < 10).events()).isEqualTo(8);
        }
    }

    @Test
    void infinityIsANumberAndNoneIsNot() throws IOException {
        try (ColumnFiles columns = columns(10)) {
            assertThat(columns.measured("reached").share(Double::isInfinite).events()).isEqualTo(8);
            assertThat(columns.measured("distance").size()).isZero();
        }
    }
}

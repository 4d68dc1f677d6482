package arcomat.cluster.spark;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;

class SparkCampaignTest {
    @ParameterizedTest
    @CsvSource({
        "4.0.0, ''",
        "4.2.0-SNAPSHOT, ''",
        "5.0.0-preview1, ''",
        "a laboratory's own, ''",
        "3.5.1, 'this is Spark 3.5.1, and campaigns need Spark 4'",
        "'', 'there is no Spark here: give this jar to spark-submit, with --class"
                + " arcomat.cluster.spark.SparkCampaign'"
    })
    void needsSpark4(String version, String refusal) {
        assertThat(SparkCampaign.refusal(version).orElse("")).isEqualTo(refusal);
    }

    @ParameterizedTest
    @CsvSource({
        "yard.campaign --out out --resume, ''",
        "yard.campaign --report at, ''",
        "yard.campaign --cluster yard, --cluster",
        "--workers=3 yard.campaign, --workers",
        "yard.campaign --at lab1:80, --at",
        "yard.campaign --secret s, --secret"
    })
    void whoMakesTheRunsIsSaidToSpark(String arguments, String wrong) {
        String refusal =
                wrong.isEmpty()
                        ? ""
                        : "leave out "
                                + wrong
                                + ": who makes the runs is what spark-submit is told by --master";
        assertThat(SparkCampaign.refusal(List.of(arguments.split(" "))).orElse(""))
                .isEqualTo(refusal);
    }
}

package arcomat.report.brick;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.BrickReport;
import arcomat.brick.jar.RobotJar.Origin;
import arcomat.brick.need.Needs;
import arcomat.brick.need.Needs.Need;
import arcomat.report.text.Style;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;

class BrickReportTextTest {
    @Test
    void sharesAreListedAndSummedUp() {
        Needs needs =
                new Needs(
                        123,
                        true,
                        new Need(OptionalLong.of(4321), false, Optional.empty()),
                        new Need(OptionalLong.of(9876), false, Optional.empty()),
                        OptionalInt.of(50));
        BrickReport report =
                new BrickReport(
                        List.of(),
                        List.of(
                                new BrickReport.Share(Origin.GENERATED, 12, 80, 20480),
                                new BrickReport.Share(Origin.HAND_WRITTEN, 1, 3, 700)),
                        needs);

        assertThat(BrickReportText.render(report, Style.PLAIN))
                .isEqualTo(
                        """
                        classes  methods  bytes  origin
                        -------  -------  -----  ---------------------
                             12  80       20480  generated from models
                              1  3        700    written by hand
                             13  83       21180  all
                        linked with leJOS: 123 of 256 classes
                        memory: about 4.3 of 49.0 kB
                        longest slice: about 9.9 of 50 ms
                        """);
    }

    @Test
    void whatIsNotKnownIsSaidToBeSo() {
        Need unknown = new Need(OptionalLong.empty(), false, Optional.of("a.B may wait"));
        Needs needs = new Needs(150, false, unknown, unknown, OptionalInt.empty());

        assertThat(BrickReportText.render(report(needs), Style.PLAIN))
                .endsWith(
                        """
                        linked with leJOS: about 150 of 256 classes
                        memory: not known: a.B may wait
                        longest slice: not known: a.B may wait
                        """);
    }

    @Test
    void whatMayWellBeLessIsSaidToBeSo() {
        Need bound = new Need(OptionalLong.of(98765), true, Optional.empty());
        Needs needs = new Needs(150, true, bound, bound, OptionalInt.of(50));

        assertThat(BrickReportText.render(report(needs), Style.PLAIN))
                .endsWith(
                        """
                        memory: at most 98.8 of 49.0 kB
                        longest slice: at most 98.8 of 50 ms
                        """);
        assertThat(bound.isAbove(50_000)).isFalse();
    }

    @Test
    void programsReadThemInJson() {
        Need unknown = new Need(OptionalLong.empty(), false, Optional.of("a.B may wait"));
        Need known = new Need(OptionalLong.of(9876), true, Optional.empty());
        Needs needs = new Needs(150, false, unknown, known, OptionalInt.of(50));

        assertThat(BrickReportJson.render(report(needs)))
                .isEqualTo(
                        """
                        {
                          "fits" : true,
                          "findings" : [ ],
                          "jar" : [ ],
                          "classes" : {
                            "number" : 150,
                            "exact" : false,
                            "limit" : 256
                          },
                          "memory" : {
                            "atMost" : false,
                            "unknown" : "a.B may wait",
                            "limit" : 49000
                          },
                          "slice" : {
                            "microseconds" : 9876,
                            "atMost" : true,
                            "limit" : 50000
                          }
                        }
                        """);
    }

    private static BrickReport report(Needs needs) {
        return new BrickReport(List.of(), List.of(), needs);
    }
}

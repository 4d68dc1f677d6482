package arcomat.report.brick;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.BrickReport;
import arcomat.brick.Origin;
import arcomat.report.text.Style;

import org.junit.jupiter.api.Test;

import java.util.List;

class BrickReportTextTest {
    @Test
    void sharesAreListedAndSummedUp() {
        BrickReport report =
                new BrickReport(
                        List.of(),
                        List.of(
                                new BrickReport.Share(Origin.GENERATED, 12, 80, 20480),
                                new BrickReport.Share(Origin.HAND_WRITTEN, 1, 3, 700)),
                        123);

        assertThat(BrickReportText.render(report, Style.PLAIN))
                .isEqualTo(
                        """
                        classes  methods  bytes  origin
                        -------  -------  -----  ---------------------
                             12  80       20480  generated from models
                              1  3        700    written by hand
                             13  83       21180  all
                        linked with leJOS: about 123 of 256 classes
                        """);
    }
}

package arcomat.report.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Row;
import arcomat.campaign.Row.Ending;
import arcomat.campaign.Trial;
import arcomat.campaign.coverage.ReachedItems;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Map;

/** A run is made again by what made its programs. */
class RunAgainTest {
    private static final Row ROW =
            new Row(
                    new Trial(3, 7, Map.of("wall", "1000")),
                    Ending.MADE,
                    "",
                    List.of(),
                    ReachedItems.UNKNOWN);

    @Test
    void namesLibrariesAndGuests() {
        RunAgain replay =
                new RunAgain(
                        "yard.world",
                        true,
                        List.of("parts", "their models"),
                        List.of("a guest.jar"));
        assertThat(replay.command(ROW))
                .isEqualTo(
                        "arcomat world yard.world --seed 7 --set wall=1000 --library parts"
                            + " --library 'their models' --with 'a guest.jar' --report build/run");
    }

    @Test
    void leavesOutWhatThereIsNot() {
        assertThat(new RunAgain("yard.world", false, List.of(), List.of()).command(ROW, "page"))
                .isEqualTo(
                        "arcomat world yard.world --seed 7 --set wall=1000 --no-limits --report"
                                + " page");
    }
}

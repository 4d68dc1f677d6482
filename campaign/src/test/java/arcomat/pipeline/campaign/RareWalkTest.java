package arcomat.pipeline.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.CampaignResult.Occurrence;
import arcomat.campaign.RareEvent;
import arcomat.campaign.statistics.Confidence;
import arcomat.campaign.statistics.ConfidenceInterval;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.ThreadEngine;
import arcomat.pipeline.campaign.engine.TrialRunner;
import arcomat.sim.device.Limits;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.nio.file.Path;
import java.time.Duration;

/** What is counted in very many runs of a world, and what a splitting says with a quarter. */
@Tag("slow")
class RareWalkTest {
    private static final Confidence SURE = new Confidence(0.95);

    private static Engine engine(Freight freight) {
        return new ThreadEngine(2, new TrialRunner(freight));
    }

    @Test
    void splittingAgreesWithCounting() throws Exception {
        Session session = Session.in(Path.of("world/src/test/resources/world/walk"), Progress.NONE);
        PrepareCampaign.Ready ready =
                session.run(
                                new PrepareCampaign(
                                        "walk.campaign",
                                        Limits.OF_THE_BRICK,
                                        Duration.ofMinutes(5),
                                        "1"))
                        .ready()
                        .orElseThrow();
        RareEvent rare = session.run(new SplitRuns(ready, RareWalkTest::engine)).orElseThrow();
        Occurrence counted =
                session
                        .run(new MakeCampaign(ready, "", false, RareWalkTest::engine))
                        .result()
                        .occurrences()
                        .stream()
                        .filter(each -> each.column().name().equals("near"))
                        .findFirst()
                        .orElseThrow();
        ConfidenceInterval bySplitting = rare.interval(SURE);
        ConfidenceInterval byCounting = counted.interval(SURE);
        assertThat(rare.runs()).isLessThan(counted.known() / 3);
        assertThat(bySplitting.low()).isLessThan(byCounting.high()).isPositive();
        assertThat(bySplitting.high()).isGreaterThan(byCounting.low()).isLessThan(0.006);
    }
}

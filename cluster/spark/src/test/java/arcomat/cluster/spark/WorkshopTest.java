package arcomat.cluster.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.cli.terminal.Version;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.PrepareCampaign;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.sim.device.Limits;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;

/** On a world with two lamps that are watched together. */
@Tag("slow")
class WorkshopTest {
    private static final Trial TRIAL = new Trial(3, 4, Map.of());

    private static Workshop workshop(String version) throws WrongUse {
        Path folder = Path.of("../../campaign/src/test/resources/campaign/joint").toAbsolutePath();
        Session session = new Session(new PathNames(folder), Progress.NONE);
        PrepareCampaign task =
                new PrepareCampaign(
                        "yard.campaign", Limits.OF_THE_BRICK, Duration.ofMinutes(1), version);
        return new Workshop(session.run(task).ready().orElseThrow().freight());
    }

    /** As Spark does, once for each process. */
    private static Workshop sent(Workshop workshop) throws IOException, ClassNotFoundException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(workshop);
        }
        return (Workshop)
                new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())).readObject();
    }

    @Test
    void whatIsPreparedStaysWhereItIs() throws Exception {
        Workshop here = workshop(Version.number());
        Row row = here.runner().apply(TRIAL);
        assertThat(row.wasMade()).isTrue();
        assertThat(here.runner()).isSameAs(here.runner());
        Workshop there = sent(here);
        assertThat(there.runner()).isNotSameAs(here.runner());
        assertThat(there.runner().apply(TRIAL)).isEqualTo(row);
    }

    @Test
    void anotherVersionMakesNoRuns() {
        assertThatThrownBy(() -> sent(workshop("0.0.9")).runner())
                .isInstanceOf(EngineFailure.class)
                .hasMessage(
                        "an executor has version %s of arcomat, and the campaign is made by version"
                                        .formatted(Version.number())
                                + " 0.0.9: look for another jar of it among Spark's");
    }
}

package arcomat.cluster.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.cli.terminal.Version;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;

import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.Map;

/** On a world without robots. */
class WorkshopTest {
    private static final Trial TRIAL = new Trial(3, 4, Map.of());

    private static Workshop workshop(String version) {
        String campaign = "world yard.world\nsample random 300\n";
        String world = "floor 1000 1000\nseconds 0.1\n";
        return new Workshop(new Freight(version, campaign, world, true, 60, Map.of()));
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

package arcomat.pipeline.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.pipeline.FourZones;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.ItemProbes;
import arcomat.pipeline.campaign.engine.ProgramItems;
import arcomat.pipeline.campaign.engine.ProgramItems.OfClass;
import arcomat.pipeline.campaign.joint.JointFreight;
import arcomat.sim.load.NotedLines;
import arcomat.sim.load.Program;

import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import java.util.zip.ZipInputStream;

class FreightTest {
    private static final Program PROGRAM =
            new Program("p.Main", Map.of("p.Main", new byte[] {1, 2}, "p.Other", new byte[0]));
    private static final Freight FREIGHT =
            new Freight(
                    "1.0",
                    "world a\n",
                    "floor 1 2\n# ü",
                    true,
                    Duration.ofSeconds(30),
                    Map.of("key /\n", PROGRAM));

    @Test
    void whatIsPackedIsUnpacked() throws Exception {
        Freight back = Freight.unpacked(FREIGHT.packed());
        assertThat(back.hash()).isEqualTo(FREIGHT.hash());
        assertThat(back.world()).isEqualTo(FREIGHT.world());
        assertThat(back.programs().get("key /\n").classes().get("p.Main")).containsExactly(1, 2);
    }

    @Test
    void thePackedBytesAreTheSameInEveryTimeZoneAndAtAnyTime() throws Exception {
        List<byte[]> packed = FourZones.each(FREIGHT::packed);
        assertThat(packed).containsOnly(packed.get(0));
        try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(packed.get(0)))) {
            assertThat(zip.getNextEntry().getTimeLocal().getYear()).isEqualTo(1980);
        }
    }

    @Test
    void whateverDiffersShowsInTheHash() {
        Program other = new Program("p.Main", Map.of("p.Main", new byte[] {1, 3}));
        assertThat(
                        Stream.of(
                                        FREIGHT,
                                        new Freight(
                                                "1.1",
                                                "world a\n",
                                                "",
                                                true,
                                                Duration.ofSeconds(30),
                                                Map.of()),
                                        new Freight(
                                                "1.0",
                                                "world b\n",
                                                "",
                                                true,
                                                Duration.ofSeconds(30),
                                                Map.of()),
                                        new Freight(
                                                "1.0",
                                                "world a\n",
                                                "x",
                                                true,
                                                Duration.ofSeconds(30),
                                                Map.of()),
                                        new Freight(
                                                "1.0",
                                                "world a\n",
                                                "",
                                                false,
                                                Duration.ofSeconds(30),
                                                Map.of()),
                                        new Freight(
                                                "1.0",
                                                "world a\n",
                                                "",
                                                true,
                                                Duration.ofSeconds(31),
                                                Map.of()),
                                        new Freight(
                                                "1.0",
                                                "world a\n",
                                                "",
                                                true,
                                                Duration.ofSeconds(30),
                                                Map.of("k", other)),
                                        new Freight(
                                                "1.0",
                                                "world a\n",
                                                "",
                                                true,
                                                Duration.ofSeconds(30),
                                                Map.of("k", PROGRAM)))
                                .map(Freight::hash))
                .doesNotHaveDuplicates();
    }

    private static ProgramItems items(int line, int number, ProgramItems.OfPart... parts) {
        NotedLines lines = new NotedLines("p.Main", List.of(line, 0, 9));
        return new ProgramItems(
                "p.Whole", List.of(new OfClass(number, 4, 1, lines)), List.of(parts));
    }

    private static Freight covering(int transitions, ProgramItems items) {
        ProgramItems none = new ProgramItems("p.None", List.of(), List.of());
        ItemProbes coverage = new ItemProbes(transitions, Map.of("key /\n", items, "other", none));
        return new Freight(
                "1",
                "",
                "",
                true,
                Duration.ofSeconds(30),
                Map.of("key /\n", PROGRAM),
                Map.of(),
                JointFreight.NONE,
                coverage);
    }

    @Test
    void whatRunsMayCoverTravelsWithTheirPrograms() throws Exception {
        ProgramItems.OfPart whole = new ProgramItems.OfPart("one", 6, "");
        ProgramItems.OfPart cell = new ProgramItems.OfPart("other", 8, "section1.cells[3]");
        Freight freight = covering(2, items(7, 0, whole, cell));
        assertThat(Freight.unpacked(freight.packed()).coverage()).isEqualTo(freight.coverage());
        assertThat(
                        Stream.of(
                                        freight,
                                        covering(2, items(7, 0, cell, whole)),
                                        covering(2, items(7, 0, whole)),
                                        covering(3, items(7, 0)),
                                        covering(2, items(7, 0)),
                                        covering(2, items(8, 0)),
                                        covering(2, items(7, 1)))
                                .map(Freight::hash))
                .doesNotHaveDuplicates();
    }

    @Test
    void otherBytesAreNone() {
        assertThatThrownBy(() -> Freight.unpacked(new byte[] {1, 2, 3}))
                .isInstanceOf(IOException.class);
    }
}

package arcomat.pipeline.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Row;
import arcomat.campaign.Trials;
import arcomat.campaign.coverage.CoverageCount;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.TrialRunner;
import arcomat.sim.device.Limits;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Parts of one component are told apart, wherever a program has them: fields, arrays, sections. */
class CoveredPartsTest {
    private static final int CELLS = 120;

    /** A reading is at most 100, so that a limit of 100 is never passed. */
    private static final String GATE =
            """
            package p;

            component Gate(Integer limit) {
                timing instant;

                port <<total>> in Integer[0..100] light;

                <<completion = "ignore">> automaton {
                    state shut, open;

                    initial shut;

                    shut -> open [light > limit];
                    open -> shut [light <= limit];
                }
            }
            """;

    private static final String PAIR =
            """
            package p;

            component Pair {
                timing instant;

                port <<total>> in Integer[0..100] light;

                component Gate(0) low;
                component Gate(100) high;

                connect light -> low.light, high.light;
            }
            """;

    private static final String WORLD =
            """
            floor 1000 1000
            seconds 1
            noise none

            kind looker
              program component p.Looker in .
              body 80 900
              light S1 at 0 0

            robot one looker at 300 500
            robot other looker at 700 500
            """;

    @TempDir private Path folder;

    private static String looker() {
        String cells =
                IntStream.range(0, CELLS)
                        .mapToObj(i -> "component Gate(%d) cell%d;\n".formatted(i % 2 * 100, i))
                        .collect(Collectors.joining());
        String targets =
                IntStream.range(0, CELLS)
                        .mapToObj(i -> ", cell%d.light".formatted(i))
                        .collect(Collectors.joining());
        return """
        package p;

        import nxt.Brick.SensorPort;
        import nxt.LightSensor;

        <<deploy>> component Looker {
            component LightSensor(SensorPort.S1) eye;
            component Pair first, second;
            %s
            connect eye.value -> first.light, second.light%s;
        }
        """
                .formatted(cells, targets);
    }

    private PrepareCampaign.Ready ready() throws Exception {
        Files.createDirectories(folder.resolve("p"));
        Files.writeString(folder.resolve("p/Gate.arc"), GATE);
        Files.writeString(folder.resolve("p/Pair.arc"), PAIR);
        Files.writeString(folder.resolve("p/Looker.arc"), looker());
        Files.writeString(folder.resolve("a.world"), WORLD);
        Files.writeString(folder.resolve("a.campaign"), "world a.world\nsample random 3\n");
        PrepareCampaign task =
                new PrepareCampaign("a.campaign", Limits.NONE, Duration.ofMinutes(1), "1");
        PrepareCampaign.Prepared prepared = Session.in(folder, Progress.NONE).run(task);
        return prepared.ready().orElseThrow(() -> new AssertionError(prepared.findings()));
    }

    @Test
    void eachPartHasWhatItHasDone() throws Exception {
        PrepareCampaign.Ready ready = ready();
        CoverageCount count = new CoverageCount(ready.items());
        TrialRunner runner = new TrialRunner(Freight.unpacked(ready.freight().packed()));
        for (int i = 0; i < 3; i++) {
            Row row = runner.apply(Trials.of(ready.campaign()).trial(i));
            count.see(row.reached());
        }
        List<String> names = new ArrayList<>();
        for (String robot : List.of("one", "other")) {
            for (String pair : List.of("first", "second")) {
                names.add(robot + "." + pair + ".low");
            }
            for (int i = 0; i < CELLS; i += 2) {
                names.add(robot + ".cell" + i);
            }
        }
        assertThat(count.coverage().parts()).hasSize(2 * (CELLS + 4));
        assertThat(count.coverage().parts())
                .allSatisfy(
                        each -> {
                            boolean opens = names.contains(each.part().name());
                            assertThat(each.transitions())
                                    .as(each.part().name())
                                    .containsExactly(opens ? 3L : 0L, 0L);
                            assertThat(each.states()).containsExactly(3L, opens ? 3L : 0L);
                        });
    }
}

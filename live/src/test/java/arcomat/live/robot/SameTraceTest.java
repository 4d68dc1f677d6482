package arcomat.live.robot;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.law.Profile;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.world.PrepareWorld;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.sim.Laboratory;
import arcomat.sim.device.Limits;
import arcomat.source.SourceFile;
import arcomat.world.Recording;
import arcomat.world.Seeds;
import arcomat.world.World;
import arcomat.world.WorldParser;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Interpreted robots do what their jars do on bricks without limits: the same places, the same
 * readings, the same events at the same moments, to the last bit.
 */
class SameTraceTest {
    private static final Path HOUSE = Path.of("..").toAbsolutePath().normalize();
    private static final long FEW = 6;
    private static final long MANY = 30;

    /** A world, by jars and interpreted. */
    private record Both(PreparedWorld jars, World world, RobotPrograms interpreted) {
        static Both of(String file, String root) throws IOException, WrongUse {
            Session session = new Session(new PathNames(HOUSE), Progress.NONE);
            PreparedWorld jars = session.run(new PrepareWorld(file, false));
            assertThat(jars.canRun()).as(jars.findings().toString()).isTrue();
            LoweredModels models =
                    CheckedModels.check(List.of(root), Profile.REQUIREMENTS, session)
                            .lower(session);
            String text = Files.readString(HOUSE.resolve(file));
            World world = WorldParser.parse(new SourceFile(file, text)).world().orElseThrow();
            return new Both(jars, world, RobotPrograms.of(world, models));
        }

        void requireSame(long seed) {
            Recording expected = jars.run(seed, Laboratory.PATIENCE, Limits.NONE);
            Recording found = interpreted.run(Seeds.of(seed));
            assertThat(found.events()).as("events, seed " + seed).isEqualTo(expected.events());
            assertThat(found.frames()).as("frames, seed " + seed).isEqualTo(expected.frames());
            assertThat(found.blind()).isEqualTo(expected.blind());
            assertThat(found.late()).isEqualTo(expected.late());
            assertThat(found.failures()).isEqualTo(expected.failures());
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({
        "models/coffee/world/meeting.world, models/coffee",
        "models/sprint/sprint.world, models/sprint",
        "live/src/test/resources/floor/fails.world, live/src/test/resources/floor",
        "src/test/resources/library/library.world, src/test/resources/library",
        "world/src/test/resources/world/walk/walk.world, world/src/test/resources/world/walk",
        "world/src/test/resources/world/plough/plough.world, world/src/test/resources/world/plough",
        "campaign/src/test/resources/campaign/joint/yard.world,"
                + " campaign/src/test/resources/campaign/joint",
        "campaign/src/test/resources/campaign/watch/yard.world,"
                + " campaign/src/test/resources/campaign/watch"
    })
    void worldsOfTheRepositoryWithSixSeeds(String file, String root) throws Exception {
        Both both = Both.of(file, root);
        for (long seed = 1; seed <= FEW; seed++) {
            both.requireSame(seed);
        }
    }

    @Test
    @Tag("slow")
    void theMeetingWithThirtySeeds() throws Exception {
        Both both = Both.of("models/coffee/world/meeting.world", "models/coffee");
        for (long seed = 1; seed <= MANY; seed++) {
            both.requireSame(seed);
        }
    }

    @Test
    @Tag("slow")
    void theService() throws Exception {
        Both.of("models/coffee/world/service.world", "models/coffee").requireSame(1);
    }
}

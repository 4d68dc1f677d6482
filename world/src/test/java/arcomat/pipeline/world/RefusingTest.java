package arcomat.pipeline.world;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.CodeLayout;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.compile.Slot;
import arcomat.pipeline.inside.Refusing;
import arcomat.sim.Laboratory;
import arcomat.sim.device.Limits;
import arcomat.sim.device.Observer;
import arcomat.sim.device.SilentObserver;
import arcomat.source.SourceFile;
import arcomat.world.Recording;
import arcomat.world.Recording.Reason;
import arcomat.world.Scene;
import arcomat.world.Seeds;
import arcomat.world.World;
import arcomat.world.WorldParser;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;

/** Why parts of programs do nothing, as the page of a world tells it. */
class RefusingTest {
    private static final Path FOLDER = Path.of("models/coffee/world");
    private static final Seeds SEEDS = Seeds.of(1);

    private static Recording explained(String name) throws Exception {
        return Shipped.world(name)
                .explain(SEEDS, Laboratory.PATIENCE, Limits.OF_THE_BRICK)
                .recording();
    }

    @Tag("slow")
    @Test
    void whoeverAsksTheRunIsTheSame() throws Exception {
        for (String name : List.of(Shipped.MEETING, Shipped.SERVICE)) {
            Recording plain = Shipped.world(name).run(SEEDS.first());
            Recording asked = explained(name);
            assertThat(plain.idle()).isEmpty();
            assertThat(asked.idle()).isNotEmpty();
            assertThat(asked.frames()).isEqualTo(plain.frames());
            assertThat(asked.events()).isEqualTo(plain.events());
            assertThat(asked.late()).isEqualTo(plain.late());
        }
    }

    @Tag("slow")
    @Test
    void tellsWhatAPartWaitsFor() throws Exception {
        Recording.Idle pilot =
                explained(Shipped.MEETING).idle().stream()
                        .filter(each -> each.robot().equals("loaded"))
                        .filter(each -> each.part().equals("avoidCrash"))
                        .findFirst()
                        .orElseThrow();
        assertThat(pilot.reasons())
                .extracting(Reason::words)
                .contains(
                        "driving -> waiting (line 26) did not fire: frontUS == tooClose: frontUS is"
                                + " clear",
                        "waiting -> driving (line 28) did not fire: frontUS == clear: frontUS is"
                                + " tooClose",
                        "");
        assertThat(pilot.reasons()).isSortedAccordingTo((a, b) -> a.time() - b.time());
        for (int i = 1; i < pilot.reasons().size(); i++) {
            Reason before = pilot.reasons().get(i - 1);
            assertThat(pilot.reasons().get(i).words()).isNotEqualTo(before.words());
        }
    }

    /** What is told not to fire has not fired: the generated code stays where it was. */
    @Tag("slow")
    @Test
    void whoHasAReasonStaysInItsState() throws Exception {
        World world = world(Shipped.SERVICE);
        Map<String, WorldPrograms.Equipment> plain = equipment(world);
        Map<String, WorldPrograms.Equipment> probed = new HashMap<>();
        Map<String, Refusing> refusing = new HashMap<>();
        plain.forEach(
                (robot, own) -> {
                    Refusing each = Refusing.of(own.layout()).orElseThrow();
                    refusing.put(robot, each);
                    probed.put(robot, own.probed(each));
                });
        Watching watching = new Watching(refusing, plain);
        WorldRun.run(world, SEEDS, probed, Laboratory.PATIENCE, Limits.OF_THE_BRICK, watching);
        assertThat(watching.wrong).isEmpty();
        assertThat(watching.moved).isGreaterThan(100);
        assertThat(watching.stayed).isGreaterThan(1000);
    }

    private static World world(String name) throws Exception {
        String text = Files.readString(FOLDER.resolve(name));
        return WorldParser.parse(new SourceFile(name, text)).world().orElseThrow();
    }

    private static Map<String, WorldPrograms.Equipment> equipment(World world) {
        Session session = Session.in(Path.of("").toAbsolutePath(), Progress.NONE);
        return WorldPrograms.of(
                        world, FOLDER.resolve("a").toString(), false, session, new ProgramCache())
                .equipment();
    }

    /** Looks at the state before and after each step. */
    private static final class Watching implements Witness {
        private final Map<String, Refusing> refusing;
        private final Map<String, String> stateFields = new HashMap<>();
        private final Map<Object, Integer> before = new IdentityHashMap<>();
        private final Map<Object, Refusing.Said> said = new IdentityHashMap<>();
        private final Set<String> wrong = new HashSet<>();
        private int moved;
        private int stayed;

        Watching(Map<String, Refusing> refusing, Map<String, WorldPrograms.Equipment> equipment) {
            this.refusing = refusing;
            for (WorldPrograms.Equipment each : equipment.values()) {
                CodeLayout layout = each.layout().orElseThrow();
                layout.components()
                        .values()
                        .forEach(place -> stateFields.put(place.className(), place.state()));
            }
        }

        /** Who can only be in one state does not note it. */
        private int state(Object object) {
            String field = Objects.requireNonNull(stateFields.get(object.getClass().getName()));
            boolean isNoted =
                    Stream.of(object.getClass().getDeclaredFields())
                            .anyMatch(each -> each.getName().equals(field));
            return isNoted ? ((Number) new Slot(object, field).get()).intValue() : 0;
        }

        @Override
        public Observer of(World.Robot robot) {
            return new SilentObserver() {
                @Override
                public void entered(long time, Object object, String method) {
                    Objects.requireNonNull(refusing.get(robot.name()))
                            .entered(0, object, method)
                            .ifPresent(
                                    each -> {
                                        said.put(object, each);
                                        before.put(object, state(object));
                                    });
                }

                @Override
                public void left(long time, Object object, String method) {
                    Refusing.Said told = said.remove(object);
                    if (told == null) {
                        return;
                    }
                    boolean moves = !before.get(object).equals(state(object));
                    moved += moves ? 1 : 0;
                    stayed += told.nearest().isPresent() ? 1 : 0;
                    if (moves && told.nearest().isPresent()) {
                        wrong.add(robot.name() + "." + told.part());
                    }
                }
            };
        }

        @Override
        public void see(Scene scene, Witness.Instruments instruments) {}

        @Override
        public void failed(String robot, String reason) {
            wrong.add(robot + ": " + reason);
        }
    }
}

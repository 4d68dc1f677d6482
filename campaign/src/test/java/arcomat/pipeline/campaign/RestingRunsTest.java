package arcomat.pipeline.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.campaign.Campaign;
import arcomat.campaign.Trial;
import arcomat.campaign.Trials;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.TrialRunner;
import arcomat.pipeline.world.PrepareWorld;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.sim.Laboratory;
import arcomat.sim.device.Limits;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Program;
import arcomat.source.SourceFile;
import arcomat.world.Recording;
import arcomat.world.Seeds;
import arcomat.world.World;
import arcomat.world.WorldParser;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TypeInsnNode;

import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Runs whose threads rest between slices are, to the bit, those whose threads do not. */
class RestingRunsTest {
    private static final Path MODELS = Path.of("models").toAbsolutePath();

    /** Both kinds of the programs of worlds. */
    private static final class Pair {
        private final Map<String, LoadedProgram> resting = new HashMap<>();
        private final Map<String, LoadedProgram> onThreads = new HashMap<>();

        Pair(Map<String, Program> programs, Limits limits) {
            programs.forEach(
                    (key, program) -> {
                        LoadedProgram loaded = LoadedProgram.forMany(program);
                        assertThat(loaded.rests(limits.counted())).as(key).isTrue();
                        resting.put(key, loaded);
                        onThreads.put(key, loaded.onThreads());
                    });
        }

        void check(World world, Seeds seeds, Limits limits) {
            assertThat(run(world, resting, seeds, limits))
                    .as("%s", seeds)
                    .isEqualTo(run(world, onThreads, seeds, limits));
        }

        private static Recording run(
                World world, Map<String, LoadedProgram> programs, Seeds seeds, Limits limits) {
            return PreparedWorld.of(world, programs).run(seeds, Laboratory.PATIENCE, limits);
        }
    }

    private static void checkWorld(String file, int seeds, Limits limits) throws WrongUse {
        PreparedWorld prepared =
                Session.in(MODELS, Progress.NONE).run(new PrepareWorld(file, false));
        Pair pair = new Pair(prepared.programs(), limits);
        World world = prepared.run(1).world();
        for (long seed = 1; seed <= seeds; seed++) {
            pair.check(world, Seeds.of(seed), limits);
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({
        "coffee/world/meeting.world, 80",
        "coffee/world/service.world, 1",
        "sprint/sprint.world, 30"
    })
    void worldsRunAsTheyDoOnThreads(String file, int seeds) throws WrongUse {
        checkWorld(file, seeds, Limits.OF_THE_BRICK);
        checkWorld(file, seeds, Limits.NONE);
    }

    private static Freight freight(String file) throws WrongUse {
        return prepared(file).freight();
    }

    private static PrepareCampaign.Ready prepared(String file) throws WrongUse {
        return Session.in(MODELS, Progress.NONE)
                .run(new PrepareCampaign(file, Limits.OF_THE_BRICK, Duration.ofMinutes(5), "1"))
                .ready()
                .orElseThrow();
    }

    private static void checkCampaign(String name, int runs) throws WrongUse {
        PrepareCampaign.Ready ready = prepared("coffee/campaigns/" + name);
        Campaign campaign = ready.campaign();
        SourceFile text = new SourceFile("world", ready.freight().world());
        Pair pair = new Pair(ready.freight().programs(), Limits.OF_THE_BRICK);
        Trials trials = Trials.of(campaign);
        long step = Math.max(1, trials.count() / runs);
        for (long number = 0; number < trials.count(); number += step) {
            Trial trial = trials.trial(number);
            World world = WorldParser.parse(text, trial.values()).world().orElseThrow();
            pair.check(world, trial.seeds(), Limits.OF_THE_BRICK);
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({
        "meeting.campaign, 150",
        "meeting-long.campaign, 150",
        "speed.campaign, 90",
        "fetchers.campaign, 60"
    })
    void campaignsRunAsTheyDoOnThreads(String name, int runs) throws WrongUse {
        checkCampaign(name, runs);
    }

    /** What a campaign makes in both ways is compared, and only that. */
    @Tag("slow")
    @Test
    void aRunThatIsAnotherOneOnThreadsIsToldLoudly() throws WrongUse {
        Freight usual = freight("coffee/campaigns/meeting.campaign");
        Map<String, Program> programs = new HashMap<>();
        usual.programs().forEach((key, program) -> programs.put(key, moody(program)));
        TrialRunner runner =
                new TrialRunner(
                        new Freight(
                                usual.version(),
                                usual.campaign(),
                                usual.world(),
                                usual.limited(),
                                usual.patience(),
                                programs));
        for (long checked : List.of(0L, 1000L, 7000L)) {
            assertThatThrownBy(() -> runner.apply(new Trial(checked, checked, Map.of())))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("the run is another one where threads do not rest");
        }
        for (long other : List.of(1L, 999L, 1001L)) {
            assertThat(runner.apply(new Trial(other, other, Map.of())).wasMade()).isTrue();
        }
        TrialRunner same = new TrialRunner(usual);
        for (long checked : List.of(0L, 1000L)) {
            assertThat(same.apply(new Trial(checked, checked, Map.of())).wasMade()).isTrue();
        }
    }

    /** A program that shows in each slice what is another number in each run. */
    private static Program moody(Program program) {
        Map<String, byte[]> classes = new HashMap<>(program.classes());
        ClassNode type = new ClassNode();
        new ClassReader(classes.get(program.mainClass())).accept(type, 0);
        for (MethodNode method : type.methods) {
            if (method.name.equals("slice")) {
                InsnList code = new InsnList();
                code.add(new TypeInsnNode(Opcodes.NEW, "java/lang/Object"));
                code.add(new InsnNode(Opcodes.DUP));
                code.add(
                        new MethodInsnNode(
                                Opcodes.INVOKESPECIAL, "java/lang/Object", "<init>", "()V"));
                code.add(
                        new MethodInsnNode(
                                Opcodes.INVOKEVIRTUAL, "java/lang/Object", "hashCode", "()I"));
                code.add(new InsnNode(Opcodes.ICONST_0));
                code.add(new InsnNode(Opcodes.ICONST_0));
                code.add(
                        new MethodInsnNode(
                                Opcodes.INVOKESTATIC, "lejos/nxt/LCD", "drawInt", "(III)V"));
                method.instructions.insert(code);
            }
        }
        ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
        type.accept(writer);
        classes.put(program.mainClass(), writer.toByteArray());
        return new Program(program.mainClass(), classes);
    }
}

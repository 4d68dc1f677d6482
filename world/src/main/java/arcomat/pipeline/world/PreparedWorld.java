package arcomat.pipeline.world;

import arcomat.generate.CodeLayout;
import arcomat.pipeline.brick.PluggedDevices;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.inside.Refusing;
import arcomat.sim.Laboratory;
import arcomat.sim.bus.I2CDevice;
import arcomat.sim.device.Limits;
import arcomat.sim.device.SensorName;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Program;
import arcomat.simulate.run.RobotRun;
import arcomat.source.Diagnostic;
import arcomat.world.Kind;
import arcomat.world.Recording;
import arcomat.world.Seeds;
import arcomat.world.Summary;
import arcomat.world.World;

import org.jspecify.annotations.Nullable;

import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;

/** A world whose robots have their programs: it can run, as often as wanted. */
public final class PreparedWorld {
    private final List<Diagnostic> findings;
    private final Aside aside;
    private final int files;
    private final @Nullable World world;
    private final Map<String, WorldPrograms.Equipment> equipment;

    PreparedWorld(
            List<Diagnostic> findings,
            Aside aside,
            int files,
            @Nullable World world,
            Map<String, WorldPrograms.Equipment> equipment) {
        this.findings = List.copyOf(findings);
        this.aside = aside;
        this.files = files;
        this.world = world;
        this.equipment = equipment;
    }

    /**
     * A world without a finding, whose programs were made before, perhaps by another process.
     *
     * @param programs by {@link Kind.Program#key}; worlds that differ in something else share them
     * @throws IllegalArgumentException where a program is missing, or a robot has a device that is
     *     described by a file: content travels, files do not
     */
    public static PreparedWorld of(World world, Map<String, LoadedProgram> programs) {
        Map<String, WorldPrograms.Equipment> equipment = new LinkedHashMap<>();
        for (World.Robot robot : world.robots()) {
            LoadedProgram program = programs.get(robot.kind().program().key());
            if (program == null) {
                throw new IllegalArgumentException("no program was made for " + robot.name());
            }
            equipment.put(
                    robot.name(),
                    new WorldPrograms.Equipment(program, Optional.empty(), devices(robot.kind())));
        }
        return new PreparedWorld(List.of(), Aside.NOTHING, 1, world, equipment);
    }

    private static PluggedDevices devices(Kind kind) {
        Map<SensorName, Supplier<I2CDevice>> devices = new EnumMap<>(SensorName.class);
        for (Kind.Described each : kind.described()) {
            Supplier<I2CDevice> device =
                    PluggedDevices.known(each.device())
                            .orElseThrow(
                                    () ->
                                            new IllegalArgumentException(
                                                    "device " + each.device() + " is a file"));
            devices.put(SensorName.values()[each.socket() - 1], device);
        }
        return new PluggedDevices(devices, List.of());
    }

    /** The programs of its robots, by {@link Kind.Program#key}; those that could be had. */
    public Map<String, Program> programs() {
        Map<String, Program> programs = new TreeMap<>();
        if (world != null) {
            for (World.Robot robot : world.robots()) {
                WorldPrograms.Equipment own = equipment.get(robot.name());
                if (own != null && own.program() != null) {
                    programs.put(robot.kind().program().key(), own.program().program());
                }
            }
        }
        return programs;
    }

    /**
     * Where programs that were made of models have what these have, by {@link Kind.Program#key}.
     */
    public Map<String, CodeLayout> layouts() {
        Map<String, CodeLayout> layouts = new TreeMap<>();
        if (world != null) {
            for (World.Robot robot : world.robots()) {
                Objects.requireNonNull(equipment.get(robot.name()))
                        .layout()
                        .ifPresent(each -> layouts.put(robot.kind().program().key(), each));
            }
        }
        return layouts;
    }

    /** About the world, and about the models of its robots. */
    public List<Diagnostic> findings() {
        return findings;
    }

    /** Models that its programs are made without. */
    public Aside aside() {
        return aside;
    }

    /** How many files were read. */
    public int files() {
        return files;
    }

    /** Whether the findings let it run. */
    public boolean canRun() {
        return findings.stream().noneMatch(Diagnostic::isError);
    }

    /** Runs it, as long as usual, on bricks as they are. */
    public Recording run(long seed) {
        return run(Seeds.of(seed), Laboratory.PATIENCE, Limits.OF_THE_BRICK);
    }

    /**
     * Runs it, to its goal or to its end, and keeps what is needed to show it again.
     *
     * @param seeds of everything that is drawn
     * @param patience how long it may take by the PC's clock
     * @param limits those of a brick that programs meet
     * @throws arcomat.sim.time.OutOfPatience where it takes longer
     */
    public Recording run(Seeds seeds, Duration patience, Limits limits) {
        WorldRecorder recorder = new WorldRecorder(ready(), seeds);
        watch(seeds, patience, limits, recorder);
        return recorder.recording();
    }

    /**
     * A run with what went on inside of the robots.
     *
     * @param inside what programs that were made of models did
     */
    public record Explained(Recording recording, List<RobotRun> inside) {
        public Explained {
            inside = List.copyOf(inside);
        }
    }

    /**
     * The same, with what the robots' programs did, and why their transitions did not fire. That
     * takes longer.
     */
    public Explained explain(Seeds seeds, Duration patience, Limits limits) {
        Map<String, Refusing> refusing = new LinkedHashMap<>();
        Map<String, WorldPrograms.Equipment> probed = new LinkedHashMap<>(equipment);
        equipment.forEach(
                (robot, own) ->
                        Refusing.of(own.layout())
                                .ifPresent(
                                        each -> {
                                            refusing.put(robot, each);
                                            probed.put(robot, own.probed(each));
                                        }));
        WorldRecorder recorder = new WorldRecorder(ready(), seeds, refusing);
        WorldRun.run(ready(), seeds, probed, patience, limits, recorder);
        List<RobotRun> inside = new ArrayList<>();
        refusing.forEach((robot, own) -> inside.add(own.run(robot)));
        return new Explained(recorder.recording(), inside);
    }

    /** The same where one seed draws everything. */
    public Recording run(long seed, Duration patience, Limits limits) {
        return run(Seeds.of(seed), patience, limits);
    }

    /** What it comes to, run as long as usual, on bricks as they are. */
    public Summary summarize(long seed) {
        return summarize(seed, Laboratory.PATIENCE, Limits.OF_THE_BRICK);
    }

    /** As {@link #run(Seeds, Duration, Limits)}, and keeps what it comes to. */
    public Summary summarize(Seeds seeds, Duration patience, Limits limits) {
        return summarize(seeds, patience, limits, Onlooker.NOBODY);
    }

    /**
     * The same while somebody looks on.
     *
     * @param beside sees what is counted
     */
    public Summary summarize(Seeds seeds, Duration patience, Limits limits, Onlooker beside) {
        WorldCounter counter = new WorldCounter(ready(), seeds.first(), beside);
        watch(seeds, patience, limits, counter);
        return counter.summary();
    }

    /** The same where one seed draws everything. */
    public Summary summarize(long seed, Duration patience, Limits limits) {
        return summarize(Seeds.of(seed), patience, limits);
    }

    /** As {@link #run(Seeds, Duration, Limits)}, before somebody who keeps what he likes. */
    public void watch(Seeds seeds, Duration patience, Limits limits, Witness witness) {
        WorldRun.run(ready(), seeds, equipment, patience, limits, witness);
    }

    private World ready() {
        if (!canRun()) {
            throw new IllegalStateException("a world with errors");
        }
        return Objects.requireNonNull(world);
    }
}

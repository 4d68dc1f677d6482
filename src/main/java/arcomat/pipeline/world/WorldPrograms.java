package arcomat.pipeline.world;

import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.brick.JarReader;
import arcomat.pipeline.brick.PluggedDevices;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.generate.Implementations;
import arcomat.pipeline.generate.RobotBuilder;
import arcomat.pipeline.generate.Targets;
import arcomat.sim.bus.I2CDevice;
import arcomat.sim.device.SensorName;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Program;
import arcomat.source.Diagnostic;
import arcomat.world.Kind;
import arcomat.world.World;
import arcomat.world.World.Robot;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeSet;
import java.util.function.Supplier;

/** Brings the programs of a world's robots: reads jars, or makes them of models; and devices. */
final class WorldPrograms {
    private static final String NO_PROGRAM = "ARC1125";
    private static final String TARGET = "lejos";
    private static final String STRANGER =
            "a device in Java runs with all your rights; read it, and run the world with"
                    + " --run-devices";

    private final World world;
    private final Path folder;
    private final boolean runDevices;
    private final Session session;
    private final Map<String, CheckedModels> checked = new LinkedHashMap<>();
    private final Map<String, LoweredModels> lowered = new HashMap<>();
    private final Map<Kind.Program, @Nullable LoadedProgram> programs = new HashMap<>();
    private final TreeSet<Diagnostic> findings = new TreeSet<>(Diagnostic.ORDER);

    private WorldPrograms(World world, Path folder, boolean runDevices, Session session) {
        this.world = world;
        this.folder = folder;
        this.runDevices = runDevices;
        this.session = session;
    }

    /** What the brick of a robot is given: its program, and devices that a team has described. */
    record Equipment(@Nullable LoadedProgram program, PluggedDevices devices) {}

    /**
     * What came of it.
     *
     * @param equipment by the names of robots; what cannot be had is missing
     * @param findings about the world and about models
     * @param files how many models were read
     * @param aside models that the programs are made without
     */
    record Result(
            Map<String, Equipment> equipment, List<Diagnostic> findings, int files, Aside aside) {}

    /**
     * @param file of the world, as the user wrote it; its paths start there
     * @param runDevices whether Java files that the world names may be compiled and run
     */
    static Result of(World world, String file, boolean runDevices, Session session)
            throws WrongUse {
        Path parent = Path.of(file).getParent();
        Path folder = parent == null ? Path.of("") : parent;
        return new WorldPrograms(world, folder, runDevices, session).load();
    }

    private Result load() throws WrongUse {
        Map<String, Equipment> byRobot = new LinkedHashMap<>();
        Map<String, PluggedDevices> devices = new HashMap<>();
        for (Robot robot : world.robots()) {
            Kind.Program wanted = robot.kind().program();
            if (!programs.containsKey(wanted)) {
                Program program = program(wanted);
                programs.put(wanted, program == null ? null : LoadedProgram.forMany(program));
            }
            if (!devices.containsKey(robot.kind().name())) {
                devices.put(robot.kind().name(), devices(robot.kind()));
            }
            byRobot.put(
                    robot.name(),
                    new Equipment(
                            programs.get(wanted),
                            Objects.requireNonNull(devices.get(robot.kind().name()))));
        }
        int files = 0;
        Aside aside = Aside.NOTHING;
        for (CheckedModels models : checked.values()) {
            files += models.result().files();
            aside = aside.and(models.aside());
        }
        return new Result(byRobot, List.copyOf(findings), files, aside);
    }

    /** Null if there is a finding about it. */
    private @Nullable Program program(Kind.Program wanted) throws WrongUse {
        String path =
                beside(wanted.form() == Kind.Program.Form.JAR ? wanted.name() : wanted.folder());
        try {
            JarReader jar =
                    wanted.form() == Kind.Program.Form.JAR
                            ? JarReader.read(path, session.names())
                            : made(wanted.name(), path);
            if (jar == null) {
                return null;
            }
            List<Diagnostic> obstacles = jar.report().obstacles();
            findings.addAll(obstacles);
            if (!obstacles.isEmpty()) {
                return null;
            }
            Program program = jar.program();
            if (!program.classes().containsKey(program.mainClass())) {
                throw new WrongUse(
                        "'%s' is no robot's jar: it names the main class %s and does not contain"
                                + " it",
                        path, program.mainClass());
            }
            return program;
        } catch (WrongUse e) {
            findings.add(Diagnostic.error(NO_PROGRAM, wanted.place(), e.getMessage()));
            return null;
        }
    }

    private PluggedDevices devices(Kind kind) {
        Map<SensorName, Supplier<I2CDevice>> devices = new EnumMap<>(SensorName.class);
        for (Kind.Described each : kind.described()) {
            boolean isFile = each.device().endsWith(".java");
            if (isFile && !runDevices) {
                findings.add(Diagnostic.error(PluggedDevices.NO_DEVICE, each.place(), STRANGER));
                continue;
            }
            String device = isFile ? beside(each.device()) : each.device();
            SensorName socket = SensorName.values()[each.socket() - 1];
            try {
                PluggedDevices plugged = PluggedDevices.of(Map.of(socket, device), session.names());
                devices.putAll(plugged.devices());
                findings.addAll(plugged.findings());
            } catch (WrongUse e) {
                findings.add(
                        Diagnostic.error(PluggedDevices.NO_DEVICE, each.place(), e.getMessage()));
            }
        }
        return new PluggedDevices(devices, List.of());
    }

    private String beside(String written) {
        return folder.resolve(written).normalize().toString().replace('\\', '/');
    }

    /** The jar of a component, the same as {@code generate} writes; null if models are faulty. */
    private @Nullable JarReader made(String component, String root) throws WrongUse {
        CheckedModels models = checked.get(root);
        if (models == null) {
            models =
                    CheckedModels.checkToExamine(
                            List.of(root), Asked.components(madeOf(root)), session);
            checked.put(root, models);
            findings.addAll(models.findings());
            if (!models.hasErrors()) {
                lowered.put(root, models.lower(session));
            }
        }
        if (models.hasErrors()) {
            return null;
        }
        return generated(
                MainComponent.find(component, Objects.requireNonNull(lowered.get(root))), models);
    }

    /** The components of a model root that programs are made of. */
    private List<String> madeOf(String root) {
        return world.robots().stream()
                .map(robot -> robot.kind().program())
                .filter(program -> program.form() == Kind.Program.Form.COMPONENT)
                .filter(program -> beside(program.folder()).equals(root))
                .map(Kind.Program::name)
                .distinct()
                .toList();
    }

    private @Nullable JarReader generated(MainComponent main, CheckedModels models)
            throws WrongUse {
        String name = main.component().qualifiedName();
        if (!main.component().parameters().isEmpty()) {
            throw new WrongUse(
                    "'" + name + "' takes arguments, and a program has nobody to give it");
        }
        session.progress().step("making the program of " + name);
        PathNames names = session.names();
        Target target = Targets.find(TARGET, names);
        Implementations own = Implementations.find(target, models.loaded().roots(names), names);
        Request request = Request.program(main.component(), Choosing.FIRST).with(own.texts());
        Generation generation = Generator.generate(request, target);
        findings.addAll(generation.findings());
        if (generation.findings().stream().anyMatch(Diagnostic::isError)) {
            return null;
        }
        RobotBuilder.Result built = RobotBuilder.build(generation, own);
        findings.addAll(built.findings());
        if (built.jars().isEmpty()) {
            return null;
        }
        String path = built.robots().get(0).jar();
        try {
            return JarReader.of(path, Objects.requireNonNull(built.jars().get(path)));
        } catch (IOException e) {
            throw new AssertionError("an archive in memory", e);
        }
    }
}

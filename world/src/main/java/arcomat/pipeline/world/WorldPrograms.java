package arcomat.pipeline.world;

import arcomat.generate.CodeLayout;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.brick.PluggedDevices;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.inside.Refusing;
import arcomat.pipeline.world.ProgramCache.Made;
import arcomat.pipeline.world.ProgramCache.Models;
import arcomat.sim.bus.I2CDevice;
import arcomat.sim.device.SensorName;
import arcomat.sim.load.LoadedProgram;
import arcomat.source.Diagnostic;
import arcomat.world.Kind;
import arcomat.world.World;
import arcomat.world.World.Robot;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Supplier;

/** Brings the programs of a world's robots: reads jars, or makes them of models; and devices. */
final class WorldPrograms {
    static final String NO_PROGRAM = "ARC1125";
    private static final String STRANGER =
            "a device in Java runs with all your rights; read it, and run the world with"
                    + " --run-devices";

    private final World world;
    private final Path folder;
    private final boolean runDevices;
    private final Session session;
    private final ProgramCache cache;
    private final Map<String, CheckedModels> checked = new LinkedHashMap<>();
    private final Map<Kind.Program, Made> programs = new HashMap<>();
    private final TreeSet<Diagnostic> findings = new TreeSet<>(Diagnostic.ORDER);

    private WorldPrograms(
            World world, Path folder, boolean runDevices, Session session, ProgramCache cache) {
        this.world = world;
        this.folder = folder;
        this.runDevices = runDevices;
        this.session = session;
        this.cache = cache;
    }

    /**
     * What the brick of a robot is given: its program, and devices that a team has described.
     *
     * @param layout where its program has what its models have; empty for a jar that was given
     */
    record Equipment(
            @Nullable LoadedProgram program, Optional<CodeLayout> layout, PluggedDevices devices) {
        /** The same, with a program that tells when its parts take their steps. */
        Equipment probed(Refusing refusing) {
            return new Equipment(refusing.probed(Objects.requireNonNull(program)), layout, devices);
        }
    }

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
     * @param cache what has been made for other worlds
     */
    static Result of(
            World world, String file, boolean runDevices, Session session, ProgramCache cache) {
        Path parent = Path.of(file).getParent();
        Path folder = parent == null ? Path.of("") : parent;
        return new WorldPrograms(world, folder, runDevices, session, cache).load();
    }

    private Result load() {
        Map<String, Equipment> byRobot = new LinkedHashMap<>();
        Map<String, PluggedDevices> devices = new HashMap<>();
        for (Robot robot : world.robots()) {
            Kind.Program wanted = robot.kind().program();
            if (!programs.containsKey(wanted)) {
                programs.put(wanted, program(wanted));
            }
            if (!devices.containsKey(robot.kind().name())) {
                devices.put(robot.kind().name(), devices(robot.kind()));
            }
            Made made = Objects.requireNonNull(programs.get(wanted));
            byRobot.put(
                    robot.name(),
                    new Equipment(
                            made.program(),
                            made.layout(),
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

    /** Without a program if there is a finding about it. */
    private Made program(Kind.Program wanted) {
        try {
            Made made =
                    wanted.form() == Kind.Program.Form.JAR
                            ? cache.jar(beside(wanted.name()), session)
                            : made(wanted.name(), beside(wanted.folder()));
            findings.addAll(made.findings());
            return made;
        } catch (WrongUse e) {
            findings.add(wanted.error(NO_PROGRAM, String.valueOf(e.getMessage())));
            return Made.NOTHING;
        }
    }

    private PluggedDevices devices(Kind kind) {
        Map<SensorName, Supplier<I2CDevice>> devices = new EnumMap<>(SensorName.class);
        for (Kind.Described each : kind.described()) {
            boolean isFile = each.isProgram();
            if (isFile && !runDevices) {
                findings.add(each.error(PluggedDevices.NO_DEVICE, STRANGER));
                continue;
            }
            String device = isFile ? beside(each.device()) : each.device();
            SensorName socket = SensorName.values()[each.socket() - 1];
            try {
                PluggedDevices plugged = cache.device(socket, device, session.names());
                devices.putAll(plugged.devices());
                findings.addAll(plugged.findings());
            } catch (WrongUse e) {
                findings.add(each.error(PluggedDevices.NO_DEVICE, String.valueOf(e.getMessage())));
            }
        }
        return new PluggedDevices(devices, List.of());
    }

    private String beside(String written) {
        return folder.resolve(written).normalize().toString().replace('\\', '/');
    }

    private Made made(String component, String root) throws WrongUse {
        Models models = cache.models(root, madeOf(root), session);
        checked.put(root, models.checked());
        findings.addAll(models.checked().findings());
        return models.lowered() == null
                ? Made.NOTHING
                : cache.component(component, root, models.lowered(), session);
    }

    /** The components of a model root that programs are made of, without their arguments. */
    private List<String> madeOf(String root) {
        return world.robots().stream()
                .map(robot -> robot.kind().program())
                .filter(program -> program.form() == Kind.Program.Form.COMPONENT)
                .filter(program -> beside(program.folder()).equals(root))
                .map(program -> program.name().replaceFirst("\\(.*", ""))
                .distinct()
                .toList();
    }
}

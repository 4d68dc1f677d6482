package arcomat.pipeline.brick;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.compile.ClassFiles;
import arcomat.pipeline.compile.ClassesInMemory;
import arcomat.pipeline.compile.Compilation;
import arcomat.pipeline.compile.MemoryCompiler;
import arcomat.pipeline.file.FileReader;
import arcomat.sim.SimulatedBrick;
import arcomat.sim.bus.Compass;
import arcomat.sim.bus.I2CDevice;
import arcomat.sim.bus.Sonar;
import arcomat.sim.bus.Thermometer;
import arcomat.sim.device.SensorName;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.lang.reflect.Constructor;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Stream;

/**
 * The devices in the sockets of a simulated brick, as a user names them: a kind that is known, or a
 * Java file that describes one.
 *
 * @param devices makes new ones for each run; empty if there are findings
 * @param findings about files
 */
public record PluggedDevices(
        Map<SensorName, Supplier<I2CDevice>> devices, List<Diagnostic> findings) {
    /** There is no such device. */
    public static final String NO_DEVICE = "ARC0809";

    private static final String JAVA = ".java";
    private static final String KINDS = "ultrasonic, compass, thermometer";

    public PluggedDevices {
        devices = Map.copyOf(devices);
        findings = List.copyOf(findings);
    }

    /** Puts new devices into the sockets of a brick. */
    public void plugInto(SimulatedBrick brick) {
        devices.forEach((socket, device) -> brick.plug(socket, device.get()));
    }

    /**
     * Finds the kinds, and compiles the files.
     *
     * @param named kinds, or paths of files, by their sockets
     * @throws WrongUse where there is neither such a kind nor such a file
     */
    public static PluggedDevices of(Map<SensorName, String> named, PathNames names)
            throws WrongUse {
        Map<SensorName, Supplier<I2CDevice>> devices = new EnumMap<>(SensorName.class);
        List<Diagnostic> findings = new ArrayList<>();
        for (Map.Entry<SensorName, String> each : new TreeMap<>(named).entrySet()) {
            if (!findings.isEmpty()) {
                break; // one file at a time
            }
            if (each.getValue().endsWith(JAVA)) {
                described(each.getValue(), names, findings)
                        .ifPresent(device -> devices.put(each.getKey(), device));
            } else {
                devices.put(each.getKey(), kind(each.getKey(), each.getValue()));
            }
        }
        return new PluggedDevices(findings.isEmpty() ? devices : Map.of(), findings);
    }

    private static Supplier<I2CDevice> kind(SensorName socket, String name) throws WrongUse {
        return known(name)
                .orElseThrow(
                        () ->
                                new WrongUse(
                                        "device '%s' in %s is neither a Java file nor one of %s",
                                        name, socket, KINDS));
    }

    /** A kind by its name, if it is one of those that need no file. */
    public static Optional<Supplier<I2CDevice>> known(String name) {
        return switch (name) {
            case "ultrasonic" -> Optional.of(Sonar::new);
            case "compass" -> Optional.of(Compass::new);
            case "thermometer" -> Optional.of(Thermometer::new);
            default -> Optional.empty();
        };
    }

    private static Optional<Supplier<I2CDevice>> described(
            String path, PathNames names, List<Diagnostic> findings) throws WrongUse {
        SourceFile file = FileReader.required("device", path, names);
        Compilation compilation =
                MemoryCompiler.compileForThisJava(Map.of(path, file.text()), available());
        if (!compilation.problems().isEmpty()) {
            compilation.problems().forEach(problem -> findings.add(finding(problem, file)));
            return Optional.empty();
        }
        try {
            Constructor<?> constructor = constructor(className(path, compilation), compilation);
            made(constructor);
            return Optional.of(() -> made(constructor));
        } catch (ReflectiveOperationException | LinkageError | ClassCastException e) {
            findings.add(
                    Diagnostic.error(
                            NO_DEVICE,
                            file.span(0, 0),
                            "this is no device: the class that the file is named after has to"
                                    + " implement arcomat.sim.bus.I2CDevice, and to be public, with"
                                    + " a public constructor without parameters"));
            return Optional.empty();
        }
    }

    /** What a description may refer to: Java itself, and what a device has to be. */
    private static ClassFiles available() {
        String bus = I2CDevice.class.getPackageName();
        Set<String> packages = new HashSet<>();
        Stream.concat(Object.class.getModule().getPackages().stream(), Stream.of(bus))
                .map(name -> name.replace('.', '/'))
                .forEach(name -> addWithOuter(name, packages));
        return ClassFiles.ofThisProgram(List.of("java/", bus.replace('.', '/') + "/"), packages);
    }

    private static void addWithOuter(String name, Set<String> packages) {
        for (int end = name.length(); end > 0; end = name.lastIndexOf('/', end - 1)) {
            packages.add(name.substring(0, end));
        }
    }

    private static Constructor<?> constructor(String name, Compilation compilation)
            throws ReflectiveOperationException {
        return new ClassesInMemory(compilation.classes()).loadClass(name).getConstructor();
    }

    private static I2CDevice made(Constructor<?> constructor) {
        try {
            return (I2CDevice) constructor.newInstance();
        } catch (ReflectiveOperationException e) {
            throw new LinkageError(constructor.getName(), e);
        }
    }

    /** The class that the file is named after, in whichever package. */
    private static String className(String path, Compilation compilation) {
        String file = path.substring(path.replace('\\', '/').lastIndexOf('/') + 1);
        String simple = file.substring(0, file.length() - JAVA.length());
        return compilation.classes().keySet().stream()
                .filter(name -> name.equals(simple) || name.endsWith("/" + simple))
                .findFirst()
                .orElse(simple)
                .replace('/', '.');
    }

    private static Diagnostic finding(Compilation.Problem problem, SourceFile file) {
        return Diagnostic.error(
                NO_DEVICE,
                problem.in(file),
                "this does not compile as a device: " + problem.message());
    }
}

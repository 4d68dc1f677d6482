package arcomat.pipeline.brick;

import arcomat.pipeline.compile.Compilation;
import arcomat.pipeline.compile.MemoryCompiler;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.WrongUse;
import arcomat.sim.SimulatedBrick;
import arcomat.sim.bus.Compass;
import arcomat.sim.bus.I2CDevice;
import arcomat.sim.bus.Sonar;
import arcomat.sim.bus.Thermometer;
import arcomat.sim.device.SensorName;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.lang.reflect.Constructor;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;

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
        return switch (name) {
            case "ultrasonic" -> Sonar::new;
            case "compass" -> Compass::new;
            case "thermometer" -> Thermometer::new;
            default ->
                    throw new WrongUse(
                            "device '%s' in %s is neither a Java file nor one of %s"
                                    .formatted(name, socket, KINDS));
        };
    }

    private static Optional<Supplier<I2CDevice>> described(
            String path, PathNames names, List<Diagnostic> findings) throws WrongUse {
        SourceFile file = FileReader.required("device", path, names);
        Compilation compilation =
                MemoryCompiler.compileForThisJava(Map.of(path, file.text()), new DeviceClasses());
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

    private static Constructor<?> constructor(String name, Compilation compilation)
            throws ReflectiveOperationException {
        return new Loader(compilation.classes()).loadClass(name).getConstructor();
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
        int length = file.text().length();
        int start = Math.min(Math.max(0, problem.start()), length);
        Span span = file.span(start, Math.min(Math.max(start, problem.end()), length));
        return Diagnostic.error(
                NO_DEVICE, span, "this does not compile as a device: " + problem.message());
    }

    /** The classes of one device; they know the simulation, and it knows what they implement. */
    private static final class Loader extends ClassLoader {
        private final Map<String, byte[]> classes;

        Loader(Map<String, byte[]> classes) {
            super(I2CDevice.class.getClassLoader());
            this.classes = classes;
        }

        @Override
        protected Class<?> findClass(String name) throws ClassNotFoundException {
            byte[] file = classes.get(name.replace('.', '/'));
            if (file == null) {
                throw new ClassNotFoundException(name);
            }
            return defineClass(name, file, 0, file.length);
        }
    }
}

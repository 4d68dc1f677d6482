package arcomat.pipeline.brick;

import arcomat.brick.BrickCheck;
import arcomat.brick.BrickReport;
import arcomat.brick.api.BrickTable;
import arcomat.brick.jar.RobotJar;
import arcomat.brick.jar.RobotJar.Origin;
import arcomat.brick.jar.RobotJar.RobotClass;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.Failures;
import arcomat.sim.load.Program;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;

/**
 * A program's jar as it was read.
 *
 * @param shown the path as the user wrote it
 * @param main qualified name of the main class
 */
public record JarReader(String shown, byte[] bytes, String main, List<RobotClass> classes) {
    private static final String CLASS = ".class";
    private static final String MANIFEST = "META-INF/MANIFEST.MF";

    /** A line of a manifest that begins with a blank goes on where the one before ended. */
    private static final Pattern FOLD = Pattern.compile("\\r?\\n ");

    private static final Pattern MAIN = Pattern.compile("(?im)^Main-Class: *(\\S+) *$");
    private static final Pattern SECTION_END = Pattern.compile("\\r?\\n\\r?\\n");

    /**
     * Far more than any brick holds, and little for a PC: a small archive may unpack to gigabytes.
     */
    private static final int MOST_BYTES = 64 << 20;

    /**
     * A jar in a file.
     *
     * @param written as the user wrote it
     * @throws WrongUse where there is none, or what is there is no robot's
     */
    public static JarReader read(String written, PathNames names) throws WrongUse {
        Path file = names.readable(written);
        if (!Files.isRegularFile(file)) {
            throw new WrongUse("there is no jar '" + written + "'");
        }
        try {
            return of(written, Files.readAllBytes(file));
        } catch (IOException | RuntimeException e) { // damaged archives give either
            throw new WrongUse("'" + written + "' cannot be read as a jar: " + Failures.reason(e));
        }
    }

    /**
     * A jar that the tool has just made.
     *
     * @throws WrongUse where it is no robot's
     */
    public static JarReader made(String path, byte[] bytes) throws WrongUse {
        try {
            return of(path, bytes);
        } catch (IOException e) {
            throw new AssertionError("an archive in memory", e);
        }
    }

    /**
     * A jar that is at hand already.
     *
     * @param shown what messages call it
     * @throws WrongUse where it is no robot's
     */
    public static JarReader of(String shown, byte[] bytes) throws IOException, WrongUse {
        List<RobotClass> classes = new ArrayList<>();
        Optional<String> main = Optional.empty();
        int room = MOST_BYTES;
        try (ZipInputStream jar = new ZipInputStream(new ByteArrayInputStream(bytes))) {
            for (ZipEntry entry = jar.getNextEntry(); entry != null; entry = jar.getNextEntry()) {
                byte[] content = jar.readNBytes(room + 1);
                room -= content.length;
                if (room < 0) {
                    throw tooLarge(shown);
                }
                if (entry.getName().equals(MANIFEST)) {
                    main = mainClass(content);
                } else if (entry.getName().endsWith(CLASS)) {
                    classes.add(classOf(entry.getName(), content));
                }
            }
        }
        String program = main.orElseThrow(() -> notAProgram(shown));
        return new JarReader(shown, bytes, program, List.copyOf(classes));
    }

    /**
     * The class that the program begins in, as the first section of the manifest names it. The
     * JDK's reader would tell on standard error what it dislikes.
     */
    static Optional<String> mainClass(byte[] manifest) {
        String text = new String(manifest, StandardCharsets.UTF_8);
        String first = SECTION_END.split(text, 2)[0];
        Matcher main = MAIN.matcher(FOLD.matcher(first).replaceAll(""));
        return main.find() ? Optional.of(main.group(1)) : Optional.empty();
    }

    private static WrongUse tooLarge(String shown) {
        return new WrongUse(
                "'%s' is no robot's jar: it holds more than %d MB when it is unpacked",
                shown, MOST_BYTES >> 20);
    }

    private static WrongUse notAProgram(String shown) {
        return new WrongUse(
                "'%s' is no robot's jar: its manifest names no Main-Class; 'arcomat generate"
                        + " --target lejos' makes such jars",
                shown);
    }

    /** Where a class of somebody's jar comes from is not known, unless its package tells. */
    private static RobotClass classOf(String path, byte[] bytes) {
        Origin origin =
                path.startsWith("arcomat/rt/")
                        ? Origin.RUNTIME
                        : path.startsWith("arcomat/nxt/") || path.startsWith("nxt/")
                                ? Origin.PLATFORM
                                : Origin.GENERATED;
        return new RobotClass(path, bytes, origin, Optional.empty());
    }

    /** What a simulated brick runs. */
    public Program program() {
        Map<String, byte[]> byName = new HashMap<>();
        for (RobotClass each : classes) {
            int length = each.path().length() - CLASS.length();
            byName.put(each.path().substring(0, length).replace('/', '.'), each.bytes());
        }
        return new Program(main, byName);
    }

    /** What the brick has and can hold, and what a simulated one has. */
    public BrickReport report() {
        return BrickCheck.checkAlsoForSimulation(jar(), BrickTable.leJos());
    }

    public RobotJar jar() {
        return new RobotJar(shown, classes);
    }
}

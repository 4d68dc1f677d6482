package arcomat.brick.jar;

import arcomat.source.SourceFile;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;

/**
 * All classes that a robot brings along, leJOS' own excepted.
 *
 * @param path the jar's path as it is shown
 */
public record RobotJar(String path, List<RobotClass> classes) {
    private static final String CLASS = ".class";

    /**
     * A class of a robot's jar.
     *
     * @param path its entry in the jar, as {@code coffee/logic/Fetcher.class}
     * @param bytes the class file; not changed by anybody
     * @param text the Java text that it was compiled from, where it is at hand: findings then name
     *     lines of it
     */
    public record RobotClass(String path, byte[] bytes, Origin origin, Optional<SourceFile> text) {}

    /** Where a class of a robot's jar comes from. */
    public enum Origin {
        /** Generated from models. */
        GENERATED,
        /** The runtime that generated code of every target needs. */
        RUNTIME,
        /** The platform library: sensors and actuators that come with the product. */
        PLATFORM,
        /** A team's own platform components. */
        HAND_WRITTEN
    }

    public RobotJar {
        classes = List.copyOf(classes);
    }

    /**
     * Takes the classes out of a jar. Bytes that are no jar have none.
     *
     * @param origin of a class, by its entry in the jar
     * @throws IOException where the jar is damaged
     */
    public static RobotJar read(String path, byte[] jar, Function<String, Origin> origin)
            throws IOException {
        List<RobotClass> classes = new ArrayList<>();
        ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(jar));
        for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
            String name = entry.getName();
            if (name.endsWith(CLASS)) {
                classes.add(
                        new RobotClass(
                                name, zip.readAllBytes(), origin.apply(name), Optional.empty()));
            }
        }
        return new RobotJar(path, classes);
    }
}

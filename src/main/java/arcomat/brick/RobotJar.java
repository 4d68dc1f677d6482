package arcomat.brick;

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

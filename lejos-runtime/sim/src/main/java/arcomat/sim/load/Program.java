package arcomat.sim.load;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashMap;
import java.util.Map;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;

/**
 * A program as it goes on the brick.
 *
 * @param mainClass the class with main, by its full name
 * @param classes class files by the full names of their classes
 */
public record Program(String mainClass, Map<String, byte[]> classes) {
    private static final String SUFFIX = ".class";

    public Program {
        classes = Map.copyOf(classes);
    }

    /**
     * Reads a jar.
     *
     * @throws IOException if it cannot be read
     * @throws ProgramException if it is no program
     */
    public static Program read(Path jar) throws IOException, ProgramException {
        try (JarFile file = new JarFile(jar.toFile())) {
            Map<String, byte[]> classes = classes(file);
            String main = mainClass(jar, file);
            if (!classes.containsKey(main)) {
                throw new ProgramException(
                        jar + " names the main class " + main + " but does not contain it");
            }
            return new Program(main, classes);
        }
    }

    private static String mainClass(Path jar, JarFile file) throws IOException, ProgramException {
        String main =
                file.getManifest() == null
                        ? null
                        : file.getManifest()
                                .getMainAttributes()
                                .getValue(Attributes.Name.MAIN_CLASS);
        if (main == null) {
            throw new ProgramException(
                    jar + " has no Main-Class in its manifest, so nothing says where it begins");
        }
        return main;
    }

    private static Map<String, byte[]> classes(JarFile file) throws IOException {
        Map<String, byte[]> classes = new HashMap<>();
        for (JarEntry entry : Collections.list(file.entries())) {
            String path = entry.getName();
            if (path.endsWith(SUFFIX)) {
                String name = path.substring(0, path.length() - SUFFIX.length());
                classes.put(name.replace('/', '.'), file.getInputStream(entry).readAllBytes());
            }
        }
        return classes;
    }
}

package arcomat.maven;

import arcomat.plugin.ModelFiles;

import org.apache.maven.artifact.DependencyResolutionRequiredException;
import org.apache.maven.project.MavenProject;

import java.io.File;
import java.io.IOException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The models of other projects that those of a project may refer to: jars with classifier {@code
 * models} among its dependencies, each unpacked to a model root.
 */
final class ModelLibraries {
    private static final String ENDING = "-" + ModelFiles.CLASSIFIER + ".jar";

    private ModelLibraries() {}

    /**
     * Unpacks them.
     *
     * @param folder for all of them, and for nothing else
     * @return model roots
     */
    static List<File> unpack(MavenProject project, File folder)
            throws IOException, DependencyResolutionRequiredException {
        Map<String, byte[]> contents = new TreeMap<>();
        for (String element : project.getCompileClasspathElements()) {
            if (element.endsWith(ENDING)) {
                Path jar = Path.of(element);
                String name = jar.getFileName().toString().replaceFirst("\\.jar$", "");
                read(jar).forEach((path, bytes) -> contents.put(name + "/" + path, bytes));
            }
        }
        new MirroredFolder(folder.toPath()).hold(contents);
        return ModelFiles.roots(folder);
    }

    private static Map<String, byte[]> read(Path jar) throws IOException {
        Map<String, byte[]> contents = new TreeMap<>();
        try (FileSystem inside = FileSystems.newFileSystem(jar)) {
            MirroredFolder.contents(inside.getPath("/"))
                    .forEach(
                            (path, bytes) -> {
                                if (ModelFiles.isForOthers(path)) {
                                    contents.put(path, bytes);
                                }
                            });
        }
        return contents;
    }
}

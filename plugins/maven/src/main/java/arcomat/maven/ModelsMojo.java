package arcomat.maven;

import arcomat.plugin.ModelFiles;

import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugins.annotations.Component;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;
import org.apache.maven.plugins.annotations.Parameter;
import org.apache.maven.project.MavenProjectHelper;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/**
 * Packs the models into a jar with classifier {@code models}, which is published with the project:
 * models of other projects may refer to them.
 */
@Mojo(name = "models", defaultPhase = LifecyclePhase.GENERATE_RESOURCES, threadSafe = true)
public final class ModelsMojo extends ToolMojo {
    /** As in other jars that are the same wherever and whenever they are made. */
    private static final LocalDateTime TIME = LocalDateTime.of(1980, 2, 1, 0, 0);

    @SuppressWarnings({"deprecation", "NullAway.Init"}) // its successor is of another library
    @Component
    private MavenProjectHelper projectHelper;

    /** The name of the jar, without its classifier. */
    @Parameter(defaultValue = "${project.build.finalName}", readonly = true, required = true)
    private String finalName;

    @Override
    void work() throws MojoExecutionException {
        File jar = built(finalName + "-" + ModelFiles.CLASSIFIER + ".jar");
        try {
            Map<String, byte[]> contents = new TreeMap<>();
            for (File root : modelFolders()) {
                contents.putAll(MirroredFolder.contents(root.toPath()));
            }
            contents.keySet().removeIf(path -> !ModelFiles.isForOthers(path));
            Files.createDirectories(jar.toPath().getParent());
            pack(contents, jar.toPath());
        } catch (IOException e) {
            throw new MojoExecutionException("cannot write " + shown(jar), e);
        }
        projectHelper.attachArtifact(project(), "jar", ModelFiles.CLASSIFIER, jar);
    }

    private static void pack(Map<String, byte[]> contents, Path jar) throws IOException {
        try (OutputStream out = Files.newOutputStream(jar);
                ZipOutputStream zip = new ZipOutputStream(out)) {
            for (Map.Entry<String, byte[]> each : contents.entrySet()) {
                ZipEntry entry = new ZipEntry(each.getKey());
                entry.setTimeLocal(TIME);
                zip.putNextEntry(entry);
                zip.write(each.getValue());
                zip.closeEntry();
            }
        }
    }
}

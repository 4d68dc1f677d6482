package arcomat.maven;

import arcomat.plugin.ToolCommand;

import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;
import org.apache.maven.plugins.annotations.ResolutionScope;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.Stream;

/** Makes a jar of each component that is deployed, a program for the brick, and looks at it. */
@Mojo(
        name = "jar",
        defaultPhase = LifecyclePhase.PACKAGE,
        threadSafe = true,
        requiresDependencyResolution = ResolutionScope.COMPILE)
public final class JarMojo extends CodeMojo {
    @Override
    void work() throws MojoExecutionException, MojoFailureException {
        File code = built("generated-sources/arcomat-lejos");
        generate("lejos", code);
        if (!code.isDirectory()) {
            return;
        }
        try {
            Path robots = Files.createDirectories(built("nxt").toPath());
            for (Path old : jars(robots)) {
                Files.delete(old);
            }
            for (Path jar : jars(code.toPath())) {
                Path robot = robots.resolve(jar.getFileName());
                Files.copy(jar, robot, StandardCopyOption.REPLACE_EXISTING);
                require(run(ToolCommand.checkBrick(shown(robot.toFile()))));
            }
        } catch (IOException e) {
            throw new MojoExecutionException("cannot write to " + shown(built("nxt")), e);
        }
    }

    private static List<Path> jars(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
        }
    }
}

package arcomat.maven;

import arcomat.plugin.ToolCommand;

import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;
import org.apache.maven.plugins.annotations.Parameter;
import org.apache.maven.plugins.annotations.ResolutionScope;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/** Runs the stream tests of models; one that stays unknown fails as well. */
@Mojo(
        name = "test",
        defaultPhase = LifecyclePhase.TEST,
        threadSafe = true,
        requiresDependencyResolution = ResolutionScope.COMPILE)
public final class TestMojo extends ToolMojo {
    /** Whether no test is run, as with those of Java. */
    @Parameter(property = "skipTests", defaultValue = "false")
    private boolean skipTests;

    @Override
    void work() throws MojoExecutionException, MojoFailureException {
        if (skipTests) {
            getLog().info("left out, as skipTests says");
            return;
        }
        if (!hasTests()) {
            getLog().info("there are no stream tests");
            return;
        }
        File results = built("surefire-reports/TEST-arc.xml");
        ToolCommand command =
                ToolCommand.test()
                        .reporting(shown(built("arcomat/test.txt")), "junit=" + shown(results));
        require(run(command, folders()));
    }

    private boolean hasTests() throws MojoExecutionException {
        for (File root : folders()) {
            try (Stream<Path> files = Files.walk(root.toPath())) {
                if (files.anyMatch(file -> file.toString().endsWith(".mt"))) {
                    return true;
                }
            } catch (IOException e) {
                throw new MojoExecutionException("cannot read " + shown(root), e);
            }
        }
        return false;
    }
}

package arcomat.maven;

import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;
import org.apache.maven.plugins.annotations.ResolutionScope;

import java.io.File;
import java.io.IOException;
import java.util.Map;

/**
 * Writes Java for models, which is compiled with that of the project; what has not changed stays as
 * it is.
 */
@Mojo(
        name = "generate",
        defaultPhase = LifecyclePhase.GENERATE_SOURCES,
        threadSafe = true,
        requiresDependencyResolution = ResolutionScope.COMPILE)
public final class GenerateMojo extends CodeMojo {
    @Override
    void work() throws MojoExecutionException, MojoFailureException {
        File out = built("generated-sources/arcomat");
        File fresh = built("arcomat/generated");
        generate("jvm", fresh);
        try {
            Map<String, byte[]> code =
                    modelFolders().isEmpty() ? Map.of() : MirroredFolder.contents(fresh.toPath());
            new MirroredFolder(out.toPath()).hold(code);
        } catch (IOException e) {
            throw new MojoExecutionException("cannot write to " + shown(out), e);
        }
        project().addCompileSourceRoot(out.getPath());
    }
}

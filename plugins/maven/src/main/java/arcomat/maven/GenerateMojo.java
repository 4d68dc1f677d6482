package arcomat.maven;

import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;

import java.io.File;

/** Writes Java for models, which is compiled with that of the project. */
@Mojo(name = "generate", defaultPhase = LifecyclePhase.GENERATE_SOURCES, threadSafe = true)
public final class GenerateMojo extends CodeMojo {
    @Override
    void work() throws MojoExecutionException, MojoFailureException {
        File out = built("generated-sources/arcomat");
        generate("jvm", out);
        project().addCompileSourceRoot(out.getPath());
    }
}

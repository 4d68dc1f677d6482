package arcomat.maven;

import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;
import org.apache.maven.plugins.annotations.Parameter;

import java.io.File;
import java.util.ArrayList;
import java.util.List;

/** Reports what is wrong with models. */
@Mojo(name = "check", defaultPhase = LifecyclePhase.INITIALIZE, threadSafe = true)
public final class CheckMojo extends ToolMojo {
    /** What models must fulfil: {@code requirements} or {@code executable}. */
    @Parameter(property = "arcomat.profile", defaultValue = "requirements")
    private String profile;

    /** Whether warnings fail the build. */
    @Parameter(property = "arcomat.warningsFail", defaultValue = "false")
    private boolean warningsFail;

    /** Findings that are known and told no more. */
    @Parameter(property = "arcomat.baseline")
    private File baseline;

    @Override
    void work() throws MojoExecutionException, MojoFailureException {
        List<String> command = new ArrayList<>(List.of("check", "--profile", profile));
        command.addAll(List.of("--state", shown(built("arcomat/check.state"))));
        command.addAll(List.of("--report", "text=" + shown(built("arcomat/check.txt"))));
        command.addAll(List.of("--report", "sarif=" + shown(built("arcomat/check.sarif"))));
        if (warningsFail) {
            command.add("--strict");
        }
        if (baseline != null) {
            command.addAll(List.of("--baseline", shown(baseline)));
        }
        command.addAll(roots());
        require(run(command));
    }
}

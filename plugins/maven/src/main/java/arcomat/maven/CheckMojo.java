package arcomat.maven;

import arcomat.plugin.ToolCommand;

import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;
import org.apache.maven.plugins.annotations.Parameter;
import org.apache.maven.plugins.annotations.ResolutionScope;

import java.io.File;
import java.util.Optional;

/** Reports what is wrong with models. */
@Mojo(
        name = "check",
        defaultPhase = LifecyclePhase.INITIALIZE,
        threadSafe = true,
        requiresDependencyResolution = ResolutionScope.COMPILE)
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
        String state = shown(built("arcomat/check.state"));
        Optional<String> known = Optional.ofNullable(baseline).map(this::shown);
        ToolCommand command =
                ToolCommand.check(profile, state, warningsFail, known)
                        .reporting(
                                shown(built("arcomat/check.txt")),
                                "sarif=" + shown(built("arcomat/check.sarif")));
        require(run(command, folders()));
    }
}

package arcomat.maven;

import arcomat.plugin.ToolCommand;

import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;
import org.apache.maven.plugins.annotations.Parameter;
import org.apache.maven.plugins.annotations.ResolutionScope;

import java.util.Optional;

/** Proves all that models say they keep; what stays unknown fails as well. */
@Mojo(
        name = "verify",
        defaultPhase = LifecyclePhase.VERIFY,
        threadSafe = true,
        requiresDependencyResolution = ResolutionScope.COMPILE)
public final class VerifyMojo extends ToolMojo {
    /** After how many seconds to give up on a question; never if absent. */
    @Parameter(property = "arcomat.seconds")
    private Integer seconds;

    @Override
    void work() throws MojoExecutionException, MojoFailureException {
        ToolCommand command =
                ToolCommand.verify(Optional.ofNullable(seconds))
                        .reporting(
                                shown(built("arcomat/verify.txt")),
                                "sarif=" + shown(built("arcomat/verify.sarif")));
        require(run(command, folders()));
    }
}

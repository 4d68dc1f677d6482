package arcomat.maven;

import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;
import org.apache.maven.plugins.annotations.Parameter;

import java.util.ArrayList;
import java.util.List;

/** Proves all that models say they keep; what stays unknown fails as well. */
@Mojo(name = "verify", defaultPhase = LifecyclePhase.VERIFY, threadSafe = true)
public final class VerifyMojo extends ToolMojo {
    /** After how many seconds to give up on a question; never if absent. */
    @Parameter(property = "arcomat.seconds")
    private Integer seconds;

    @Override
    void work() throws MojoExecutionException, MojoFailureException {
        List<String> command = new ArrayList<>(List.of("verify"));
        if (seconds != null) {
            command.addAll(List.of("--timeout", seconds.toString()));
        }
        command.addAll(List.of("--report", "text=" + shown(built("arcomat/verify.txt"))));
        command.addAll(List.of("--report", "sarif=" + shown(built("arcomat/verify.sarif"))));
        command.addAll(roots());
        require(run(command));
    }
}

package arcomat.maven;

import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.Parameter;

import java.io.File;
import java.util.ArrayList;
import java.util.List;

/** A goal that makes code of models. */
abstract class CodeMojo extends ToolMojo {
    /** The only component to write code for, with its parts and a program; all if absent. */
    @Parameter(property = "arcomat.main")
    private String main;

    /** What the code does where a model leaves a choice: {@code first} or {@code random}. */
    @Parameter(property = "arcomat.choose", defaultValue = "first")
    private String choose;

    /**
     * Writes code of the models, without their tests.
     *
     * @param out the folder, which is replaced as a whole
     */
    final void generate(String target, File out)
            throws MojoExecutionException, MojoFailureException {
        if (models().isEmpty()) {
            getLog().info("there are only tests, and no models to write code for");
            return;
        }
        List<String> command = new ArrayList<>(List.of("generate", "--target", target));
        command.addAll(List.of("--out", shown(out), "--choose", choose));
        if (main != null) {
            command.addAll(List.of("--main", main));
        }
        command.addAll(models());
        require(run(command));
    }
}

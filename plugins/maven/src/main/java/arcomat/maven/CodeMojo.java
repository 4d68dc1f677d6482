package arcomat.maven;

import arcomat.plugin.ToolCommand;

import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.Parameter;

import java.io.File;
import java.util.Optional;

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
        if (modelFolders().isEmpty()) {
            getLog().info("there are only tests, and no models to write code for");
            return;
        }
        ToolCommand command =
                ToolCommand.generate(target, shown(out), choose, Optional.ofNullable(main));
        require(run(command, modelFolders()));
    }
}

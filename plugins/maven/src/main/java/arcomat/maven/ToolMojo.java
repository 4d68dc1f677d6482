package arcomat.maven;

import arcomat.cli.Embedded;
import arcomat.plugin.CommandResult;

import org.apache.maven.plugin.AbstractMojo;
import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.Parameter;
import org.apache.maven.project.MavenProject;

import java.io.File;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** A goal that runs commands of the tool on the models of a project. */
abstract class ToolMojo extends AbstractMojo {
    /** The project. */
    @Parameter(defaultValue = "${project}", readonly = true, required = true)
    private MavenProject project;

    /** The folder that findings name their files from: that of the whole build. */
    @Parameter(
            defaultValue = "${session.request.multiModuleProjectDirectory}",
            readonly = true,
            required = true)
    private File directory;

    /** The folder of what is made. */
    @Parameter(defaultValue = "${project.build.directory}", readonly = true, required = true)
    private File build;

    /** The models: a model root. */
    @Parameter(property = "arcomat.models", defaultValue = "${project.basedir}/src/main/arc")
    private File models;

    /** Tests, and models that only they need: a model root. */
    @Parameter(property = "arcomat.tests", defaultValue = "${project.basedir}/src/test/arc")
    private File tests;

    /** Whether the goal does nothing. */
    @Parameter(property = "arcomat.skip", defaultValue = "false")
    private boolean skip;

    @Override
    public final void execute() throws MojoExecutionException, MojoFailureException {
        if (skip) {
            getLog().info("left out, as arcomat.skip says");
        } else if (roots().isEmpty()) {
            getLog().info("there are no models in " + shown(models));
        } else {
            work();
        }
    }

    /** Does the work of the goal, on models that are there. */
    abstract void work() throws MojoExecutionException, MojoFailureException;

    final MavenProject project() {
        return project;
    }

    /** A place below the folder of what is made. */
    final File built(String path) {
        return new File(build, path);
    }

    /** The models, as the tool is told of them. */
    final List<String> models() {
        return models.isDirectory() ? List.of(shown(models)) : List.of();
    }

    /** Models and tests, as the tool is told of them. */
    final List<String> roots() {
        return folders().stream().map(this::shown).toList();
    }

    /** Models and tests, as far as they are there. */
    final List<File> folders() {
        return Stream.of(models, tests).filter(File::isDirectory).toList();
    }

    /** A file as the tool is told of it, and as it tells of it. */
    final String shown(File file) {
        Path root = directory.toPath().toAbsolutePath().normalize();
        Path path = file.toPath().toAbsolutePath().normalize();
        return path.startsWith(root)
                ? root.relativize(path).toString().replace('\\', '/')
                : path.toString();
    }

    /** Runs a command to its end; whatever it says is in the result. */
    final CommandResult run(List<String> command) throws MojoExecutionException {
        getLog().debug("arcomat " + String.join(" ", command));
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        try {
            int status =
                    Embedded.run(
                            directory.toPath().toAbsolutePath().normalize(),
                            new PrintWriter(out, true),
                            new PrintWriter(err, true),
                            command.toArray(String[]::new));
            return new CommandResult(status, out.toString(), err.toString());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new MojoExecutionException("the build was told to end");
        }
    }

    /**
     * Fails the goal unless all is well, with one sentence; what leads to it is in the log.
     *
     * @throws MojoFailureException where the models are not as they should be
     * @throws MojoExecutionException where the command could not do its work
     */
    final void require(CommandResult result) throws MojoExecutionException, MojoFailureException {
        if (!result.isFine() && result.hasDetails()) {
            getLog().error(result.out().stripTrailing());
        }
        if (result.isWrongUse()) {
            throw new MojoExecutionException(result.failure());
        }
        if (!result.isFine()) {
            throw new MojoFailureException(result.failure());
        }
        if (!result.out().isBlank()) {
            getLog().info(result.summary());
        }
    }
}

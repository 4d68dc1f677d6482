package arcomat.maven;

import arcomat.cli.Embedded;
import arcomat.plugin.CommandResult;
import arcomat.plugin.ToolCommand;

import org.apache.maven.artifact.DependencyResolutionRequiredException;
import org.apache.maven.plugin.AbstractMojo;
import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.Parameter;
import org.apache.maven.project.MavenProject;

import java.io.File;
import java.io.IOException;
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
        } else if (folders().isEmpty()) {
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

    /** The models, without tests, as far as they are there. */
    final List<File> modelFolders() {
        return Stream.of(models).filter(File::isDirectory).toList();
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

    /**
     * Runs a command about models to its end; they may refer to those of other projects.
     *
     * @param roots of the project's models
     */
    final CommandResult run(ToolCommand command, List<File> roots) throws MojoExecutionException {
        File folder = built("arcomat/libraries");
        try {
            List<File> libraries = ModelLibraries.unpack(project, folder);
            List<File> guests = PluginGuests.of(ToolMojo.class.getClassLoader());
            return run(command.with("--with", shown(guests)).about(shown(roots), shown(libraries)));
        } catch (IOException e) {
            throw new MojoExecutionException("cannot unpack models to " + shown(folder), e);
        } catch (DependencyResolutionRequiredException e) {
            throw new MojoExecutionException("dependencies are not resolved", e);
        }
    }

    private List<String> shown(List<File> files) {
        return files.stream().map(this::shown).toList();
    }

    /** Runs a command to its end; whatever it says is in the result. */
    final CommandResult run(ToolCommand command) throws MojoExecutionException {
        getLog().debug(command.toString());
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        try {
            int status =
                    Embedded.run(
                            directory.toPath().toAbsolutePath().normalize(),
                            new PrintWriter(out, true),
                            new PrintWriter(err, true),
                            command.words().toArray(String[]::new));
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

package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.file.ConfigurableFileCollection;
import org.gradle.api.tasks.IgnoreEmptyDirectories;
import org.gradle.api.tasks.InputFiles;
import org.gradle.api.tasks.PathSensitive;
import org.gradle.api.tasks.PathSensitivity;
import org.gradle.api.tasks.SkipWhenEmpty;

import java.io.File;
import java.util.List;

/** A task about the jars of robots, one after the other. */
public abstract class JarTask extends ToolTask {
    /** One jar for each component that is deployed. */
    @InputFiles
    @SkipWhenEmpty
    @IgnoreEmptyDirectories
    @PathSensitive(PathSensitivity.RELATIVE)
    public abstract ConfigurableFileCollection getJars();

    /** What to do with a jar. */
    abstract ToolCommand command(File jar);

    @Override
    final List<ToolCommand> commands() {
        return getJars().getFiles().stream().sorted().map(this::command).toList();
    }
}

package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.file.ConfigurableFileCollection;
import org.gradle.api.file.DirectoryProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.CacheableTask;
import org.gradle.api.tasks.IgnoreEmptyDirectories;
import org.gradle.api.tasks.Input;
import org.gradle.api.tasks.InputDirectory;
import org.gradle.api.tasks.InputFiles;
import org.gradle.api.tasks.Optional;
import org.gradle.api.tasks.OutputDirectory;
import org.gradle.api.tasks.PathSensitive;
import org.gradle.api.tasks.PathSensitivity;

/** Writes code for models: for a target that the tool has, or with templates of one's own. */
@CacheableTask
public abstract class GenerateArc extends ModelTask {
    /** What to write code for: {@code jvm} or {@code lejos}. */
    @Input
    @Optional
    public abstract Property<String> getTarget();

    /** A folder of templates, instead of a target that the tool has. */
    @InputDirectory
    @Optional
    @PathSensitive(PathSensitivity.RELATIVE)
    public abstract DirectoryProperty getTemplates();

    /** Code written by hand beside the models, for platform components. */
    @InputFiles
    @IgnoreEmptyDirectories
    @PathSensitive(PathSensitivity.RELATIVE)
    public abstract ConfigurableFileCollection getPlatformCode();

    /** The only component to write code for, with its parts and a program; all if absent. */
    @Input
    @Optional
    public abstract Property<String> getMain();

    /** What the code does where a model leaves a choice: {@code first} or {@code random}. */
    @Input
    public abstract Property<String> getChoose();

    /** The folder to write, which is replaced as a whole. */
    @OutputDirectory
    public abstract DirectoryProperty getOutput();

    @Override
    final ToolCommand command() {
        String target =
                getTemplates().isPresent()
                        ? shown(getTemplates().get().getAsFile())
                        : getTarget().get();
        return ToolCommand.generate(
                target, shown(getOutput().get().getAsFile()), getChoose().get(), said(getMain()));
    }

    @Override
    final void conclude(ToolResult result) {
        result.requireOutput(getLogger());
        getLogger().info(result.out().stripTrailing());
    }
}

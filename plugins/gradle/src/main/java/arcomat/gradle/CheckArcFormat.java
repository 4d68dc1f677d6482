package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.tasks.CacheableTask;
import org.gradle.api.tasks.OutputFile;

/** Fails when a model is not in canonical form. */
@CacheableTask
public abstract class CheckArcFormat extends ModelTask {
    /** Which files would change. */
    @OutputFile
    public abstract RegularFileProperty getReport();

    @Override
    final ToolCommand command() {
        return ToolCommand.of("format", "--check");
    }

    @Override
    final void conclude(ToolResult result) {
        Texts.write(getReport(), result.out());
        result.require(getLogger());
    }
}

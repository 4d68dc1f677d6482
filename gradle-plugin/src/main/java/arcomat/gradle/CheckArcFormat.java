package arcomat.gradle;

import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.tasks.CacheableTask;
import org.gradle.api.tasks.OutputFile;
import org.gradle.api.tasks.TaskAction;

import java.util.List;

/** Fails when a model is not in canonical form. */
@CacheableTask
public abstract class CheckArcFormat extends ModelTask {
    /** Which files would change. */
    @OutputFile
    public abstract RegularFileProperty getReport();

    @TaskAction
    final void checkFormat() {
        ToolResult result = runOnModels(List.of("format", "--check"));
        Texts.write(getReport(), result.out());
        result.require(getLogger());
    }
}

package arcomat.gradle;

import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.tasks.CacheableTask;
import org.gradle.api.tasks.OutputFile;

import java.util.List;

/** Fails when a model is not in canonical form. */
@CacheableTask
public abstract class CheckArcFormat extends ModelTask {
    /** Which files would change. */
    @OutputFile
    public abstract RegularFileProperty getReport();

    @Override
    final List<String> command() {
        return List.of("format", "--check");
    }

    @Override
    final void conclude(ToolResult result) {
        Texts.write(getReport(), result.out());
        result.require(getLogger());
    }
}

package arcomat.gradle;

import org.gradle.api.tasks.CacheableTask;
import org.gradle.api.tasks.TaskAction;

import java.util.List;

/** Fails when a model is not in canonical form. */
@CacheableTask
public abstract class CheckArcFormat extends ReportTask {
    @TaskAction
    final void checkFormat() {
        report(List.of("format", "--check"));
    }
}

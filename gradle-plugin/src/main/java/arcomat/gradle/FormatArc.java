package arcomat.gradle;

import org.gradle.api.tasks.TaskAction;
import org.gradle.api.tasks.UntrackedTask;

import java.util.List;

/** Rewrites models in canonical form. */
@UntrackedTask(because = "It writes what it reads.")
public abstract class FormatArc extends ModelTask {
    @TaskAction
    final void format() {
        ToolResult result = runOnModels(List.of("format"));
        result.require(getLogger());
        getLogger().lifecycle(result.out().stripTrailing());
    }
}

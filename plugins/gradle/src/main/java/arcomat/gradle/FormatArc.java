package arcomat.gradle;

import org.gradle.api.tasks.UntrackedTask;

import java.util.List;

/** Rewrites models in canonical form. */
@UntrackedTask(because = "It writes what it reads.")
public abstract class FormatArc extends ModelTask {
    @Override
    final List<String> command() {
        return List.of("format");
    }

    @Override
    final void conclude(ToolResult result) {
        result.require(getLogger());
        getLogger().lifecycle(result.out().stripTrailing());
    }
}

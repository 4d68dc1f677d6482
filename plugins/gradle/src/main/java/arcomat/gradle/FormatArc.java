package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.tasks.UntrackedTask;

/** Rewrites models in canonical form. */
@UntrackedTask(because = "It writes what it reads.")
public abstract class FormatArc extends ModelTask {
    @Override
    final ToolCommand command() {
        return ToolCommand.of("format");
    }

    @Override
    final void conclude(ToolResult result) {
        result.require(getLogger());
        getLogger().lifecycle(result.out().stripTrailing());
    }
}

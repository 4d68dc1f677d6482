package arcomat.gradle;

import org.gradle.api.provider.Property;
import org.gradle.api.tasks.CacheableTask;
import org.gradle.api.tasks.Input;
import org.gradle.api.tasks.TaskAction;

import java.util.ArrayList;
import java.util.List;

/** Reports what is wrong with models. */
@CacheableTask
public abstract class CheckArc extends ReportTask {
    /** What models must fulfil: {@code requirements} or {@code executable}. */
    @Input
    public abstract Property<String> getProfile();

    /** Whether warnings fail the build. */
    @Input
    public abstract Property<Boolean> getWarningsFail();

    @TaskAction
    final void check() {
        List<String> command = new ArrayList<>(List.of("check", "--profile", getProfile().get()));
        if (getWarningsFail().get()) {
            command.add("--strict");
        }
        ToolResult result = report(command);
        if (result.hasDetails()) {
            getLogger().warn(result.out().stripTrailing());
        }
    }
}

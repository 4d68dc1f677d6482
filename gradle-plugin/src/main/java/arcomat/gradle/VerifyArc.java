package arcomat.gradle;

import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.CacheableTask;
import org.gradle.api.tasks.Input;
import org.gradle.api.tasks.Optional;
import org.gradle.api.tasks.OutputFile;
import org.gradle.api.tasks.TaskAction;

import java.util.ArrayList;
import java.util.List;

/** Proves all that models say they keep; what stays unknown fails as well. */
@CacheableTask
public abstract class VerifyArc extends ReportTask {
    /** After how many seconds to give up on a question; never if absent. */
    @Input
    @Optional
    public abstract Property<Integer> getSeconds();

    /** Broken promises for code scanning. */
    @OutputFile
    public abstract RegularFileProperty getSarif();

    @TaskAction
    final void verify() {
        List<String> command = new ArrayList<>(List.of("verify"));
        if (getSeconds().isPresent()) {
            command.addAll(List.of("--timeout", getSeconds().get().toString()));
        }
        ToolResult result = report(command, "sarif", getSarif());
        getLogger().info(result.out().stripTrailing());
    }
}

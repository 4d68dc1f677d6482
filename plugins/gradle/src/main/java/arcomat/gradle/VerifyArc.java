package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.CacheableTask;
import org.gradle.api.tasks.Input;
import org.gradle.api.tasks.Optional;
import org.gradle.api.tasks.OutputFile;

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

    @Override
    final ToolCommand question() {
        return ToolCommand.verify(said(getSeconds()));
    }

    @Override
    final String machineReport() {
        return "sarif=" + shown(getSarif().get().getAsFile());
    }

    @Override
    final void praise(ToolResult result) {
        getLogger().info(result.out().stripTrailing());
    }
}

package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.GradleException;
import org.gradle.api.file.RegularFile;
import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.CacheableTask;
import org.gradle.api.tasks.Input;
import org.gradle.api.tasks.InputFiles;
import org.gradle.api.tasks.LocalState;
import org.gradle.api.tasks.Optional;
import org.gradle.api.tasks.OutputFile;
import org.gradle.api.tasks.PathSensitive;
import org.gradle.api.tasks.PathSensitivity;

import java.io.File;

/** Reports what is wrong with models. */
@CacheableTask
public abstract class CheckArc extends ReportTask {
    /** What models must fulfil: {@code requirements} or {@code executable}. */
    @Input
    public abstract Property<String> getProfile();

    /** Whether warnings fail the build. */
    @Input
    public abstract Property<Boolean> getWarningsFail();

    /**
     * Findings that are known and told no more; a file that is not there yet has its own message.
     */
    @InputFiles
    @Optional
    @PathSensitive(PathSensitivity.RELATIVE)
    public abstract RegularFileProperty getBaseline();

    /** Whether there is to be a baseline: one that is missing is not the same as none. */
    @Input
    public boolean isWithBaseline() {
        return getBaseline().isPresent();
    }

    /** What the tool remembers, in order to check only what changed and what depends on it. */
    @LocalState
    public abstract RegularFileProperty getMemory();

    /** The findings for code scanning. */
    @OutputFile
    public abstract RegularFileProperty getSarif();

    @Override
    final ToolCommand question() {
        return ToolCommand.check(
                getProfile().get(),
                shown(getMemory().get().getAsFile()),
                getWarningsFail().get(),
                said(getBaseline()).map(RegularFile::getAsFile).map(this::baseline));
    }

    private String baseline(File file) {
        if (!file.exists()) {
            throw new GradleException(
                    "there is no baseline '" + shown(file) + "'; the task baselineArc writes it");
        }
        return shown(file);
    }

    @Override
    final String machineReport() {
        return "sarif=" + shown(getSarif().get().getAsFile());
    }

    @Override
    final void praise(ToolResult result) {
        if (result.hasDetails()) {
            getLogger().warn(result.out().stripTrailing());
        }
    }
}

package arcomat.gradle;

import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.Internal;
import org.gradle.api.tasks.OutputFile;

import java.util.ArrayList;
import java.util.List;

/** A task whose result is a report: a text for people, and what machines read beside it. */
public abstract class ReportTask extends ModelTask {
    /** What was found, as text. */
    @OutputFile
    public abstract RegularFileProperty getReport();

    /** How bad news is told in the log: {@code text}, or {@code github} where that is read. */
    @Internal
    public abstract Property<String> getLogFormat();

    /**
     * Runs a command on all models, writes the reports, and fails the task if the news is bad.
     *
     * @param machine the format that machines read
     */
    final ToolResult report(List<String> command, String machine, RegularFileProperty file) {
        List<String> arguments = new ArrayList<>(command);
        arguments.addAll(List.of("--format", getLogFormat().get()));
        arguments.addAll(List.of("--report", "text=" + shown(getReport().get().getAsFile())));
        arguments.addAll(List.of("--report", machine + "=" + shown(file.get().getAsFile())));
        ToolResult result = runOnModels(arguments);
        result.require(getLogger());
        return result;
    }
}

package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.Internal;
import org.gradle.api.tasks.OutputFile;

import java.util.Optional;

/** A task whose result is a report: a text for people, and what machines read beside it. */
public abstract class ReportTask extends ModelTask {
    /** What was found, as text. */
    @OutputFile
    public abstract RegularFileProperty getReport();

    /** How bad news is told in the log: {@code text}, or {@code github} where that is read. */
    @Internal
    public abstract Property<String> getLogFormat();

    /** What to look for: a command without its reports. */
    abstract ToolCommand question();

    /** The report that machines read, as {@code FORMAT=FILE}. */
    abstract String machineReport();

    /** Tells good news. */
    abstract void praise(ToolResult result);

    @Override
    final ToolCommand command() {
        return question()
                .with("--format", Optional.of(getLogFormat().get()))
                .reporting(shown(getReport().get().getAsFile()), machineReport());
    }

    @Override
    final void conclude(ToolResult result) {
        result.require(getLogger());
        praise(result);
    }
}

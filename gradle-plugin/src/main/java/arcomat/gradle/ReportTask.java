package arcomat.gradle;

import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.tasks.OutputFile;

import java.util.List;

/** A task whose result is a text for people, in the log if it is bad news, and in a file. */
public abstract class ReportTask extends ModelTask {
    /** What the task found. */
    @OutputFile
    public abstract RegularFileProperty getReport();

    /** Runs a command on all models, keeps what it found, and fails the task if that is bad. */
    final ToolResult report(List<String> command) {
        ToolResult result = runOnModels(command);
        Texts.write(getReport(), result.out());
        result.require(getLogger());
        return result;
    }
}

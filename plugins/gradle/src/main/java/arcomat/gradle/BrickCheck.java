package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.tasks.CacheableTask;
import org.gradle.api.tasks.OutputFile;

import java.io.File;
import java.util.List;
import java.util.stream.Collectors;

/** Reports what the jars of robots need on the brick, and fails if it does not have that. */
@CacheableTask
public abstract class BrickCheck extends JarTask {
    /** What each jar holds and needs. */
    @OutputFile
    public abstract RegularFileProperty getReport();

    @Override
    final ToolCommand command(File jar) {
        return ToolCommand.checkBrick(shown(jar));
    }

    @Override
    final void conclude(List<ToolResult> results) {
        String report = results.stream().map(ToolResult::out).collect(Collectors.joining("\n"));
        Texts.write(getReport(), report);
        results.forEach(result -> result.require(getLogger()));
        getLogger().info(report.stripTrailing());
    }
}

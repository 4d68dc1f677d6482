package arcomat.gradle;

import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.tasks.CacheableTask;
import org.gradle.api.tasks.OutputFile;
import org.gradle.api.tasks.TaskAction;

import java.io.File;
import java.util.List;

/** Reports what the jars of robots need on the brick, and fails if it does not have that. */
@CacheableTask
public abstract class BrickCheck extends JarTask {
    /** What each jar holds and needs. */
    @OutputFile
    public abstract RegularFileProperty getReport();

    @TaskAction
    final void check() {
        StringBuilder report = new StringBuilder();
        for (File jar : jars()) {
            ToolResult result = run(List.of("check-brick", "--jar", shown(jar)));
            report.append(result.out());
            Texts.write(getReport(), report.toString());
            result.require(getLogger());
            getLogger().info(result.out().stripTrailing());
        }
    }
}

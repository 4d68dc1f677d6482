package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.Action;
import org.gradle.api.DefaultTask;
import org.gradle.api.Task;
import org.gradle.api.file.ConfigurableFileCollection;
import org.gradle.api.file.DirectoryProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.Classpath;
import org.gradle.api.tasks.Internal;
import org.gradle.api.tasks.TaskAction;
import org.gradle.workers.WorkQueue;
import org.gradle.workers.WorkerExecutor;

import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import javax.inject.Inject;

/**
 * A task that runs commands of the tool, in worker processes: the build goes on with other tasks
 * meanwhile, and a process serves the commands of a build one after the other. There are two
 * actions, for Gradle waits between them without keeping the project to itself, as it would while
 * one action waits.
 */
public abstract class ToolTask extends DefaultTask {
    protected ToolTask() {
        doLast(new Conclusion());
    }

    /** The tool with all that it needs. */
    @Classpath
    public abstract ConfigurableFileCollection getTool();

    /** The folder that findings name their files from: that of the whole build. */
    @Internal
    public abstract DirectoryProperty getDirectory();

    /** How much memory the tool's process may use, such as {@code 2g}. */
    @Internal
    public abstract Property<String> getMaxHeapSize();

    @Inject
    protected abstract WorkerExecutor getWorkers();

    /** What to run. */
    abstract List<ToolCommand> commands();

    /** Tells what came of the commands, in their order; an exception fails the task. */
    abstract void conclude(List<ToolResult> results);

    @TaskAction
    final void start() {
        WorkQueue queue =
                getWorkers()
                        .processIsolation(
                                worker -> {
                                    worker.getClasspath().from(getTool());
                                    worker.getForkOptions().setMaxHeapSize(getMaxHeapSize().get());
                                    worker.getForkOptions().jvmArgs("-XX:+UseSerialGC");
                                });
        int number = 0;
        for (ToolCommand command : commands()) {
            getLogger().info(command.toString());
            ToolOutput output = new ToolOutput(getTemporaryDir(), number++);
            queue.submit(
                    ToolRun.class,
                    it -> {
                        it.getDirectory().set(getDirectory());
                        it.getArguments().set(command.words());
                        it.getOut().set(output.out());
                        it.getErr().set(output.err());
                        it.getStatus().set(output.status());
                    });
        }
    }

    /** The second action. */
    private static final class Conclusion implements Action<Task> {
        @Override
        public void execute(Task task) {
            ToolTask it = (ToolTask) task;
            List<ToolResult> results = new ArrayList<>();
            for (int number = 0; number < it.commands().size(); number++) {
                ToolResult result = new ToolOutput(it.getTemporaryDir(), number).result();
                it.getLogger().info(result.err().stripTrailing());
                results.add(result);
            }
            it.conclude(results);
        }
    }

    /** A file as the tool is told of it, and as it tells of it. */
    final String shown(File file) {
        Path directory = getDirectory().get().getAsFile().toPath();
        Path path = file.toPath();
        return path.startsWith(directory) ? directory.relativize(path).toString() : path.toString();
    }
}

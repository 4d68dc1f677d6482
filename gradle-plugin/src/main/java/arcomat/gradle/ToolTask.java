package arcomat.gradle;

import org.gradle.api.DefaultTask;
import org.gradle.api.file.ConfigurableFileCollection;
import org.gradle.api.file.DirectoryProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.Classpath;
import org.gradle.api.tasks.Internal;
import org.gradle.workers.WorkQueue;
import org.gradle.workers.WorkerExecutor;

import java.io.File;
import java.nio.file.Path;
import java.util.List;

import javax.inject.Inject;

/**
 * A task that runs a command of the tool, in a worker process: the build goes on with other tasks
 * meanwhile, and the process waits for the next command, in this build or a later one.
 */
public abstract class ToolTask extends DefaultTask {
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

    /** Runs a command and waits for its end. */
    final ToolResult run(List<String> arguments) {
        File out = new File(getTemporaryDir(), "out.txt");
        File err = new File(getTemporaryDir(), "err.txt");
        File status = new File(getTemporaryDir(), "status.txt");
        getLogger().info("arcomat {}", String.join(" ", arguments));
        WorkQueue queue =
                getWorkers()
                        .processIsolation(
                                worker -> {
                                    worker.getClasspath().from(getTool());
                                    worker.getForkOptions().setMaxHeapSize(getMaxHeapSize().get());
                                    worker.getForkOptions().jvmArgs("-XX:+UseSerialGC");
                                });
        queue.submit(
                ToolRun.class,
                it -> {
                    it.getDirectory().set(getDirectory());
                    it.getArguments().set(arguments);
                    it.getOut().set(out);
                    it.getErr().set(err);
                    it.getStatus().set(status);
                });
        queue.await();
        return new ToolResult(
                Integer.parseInt(Texts.read(status)), Texts.read(out), Texts.read(err));
    }

    /** A file as the tool is told of it, and as it tells of it. */
    final String shown(File file) {
        Path directory = getDirectory().get().getAsFile().toPath();
        Path path = file.toPath();
        return path.startsWith(directory) ? directory.relativize(path).toString() : path.toString();
    }
}

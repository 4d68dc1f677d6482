package arcomat.gradle;

import org.gradle.api.file.DirectoryProperty;
import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.provider.ListProperty;
import org.gradle.workers.WorkAction;
import org.gradle.workers.WorkParameters;

import java.io.IOException;
import java.io.PrintWriter;
import java.lang.reflect.InvocationTargetException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** One command of the tool, in the worker process that has the tool on its class path. */
public abstract class ToolRun implements WorkAction<ToolRun.Parameters> {
    private static final String ENTRY = "arcomat.cli.Embedded";

    /** What to run, and the files that tell the task what came of it. */
    public interface Parameters extends WorkParameters {
        DirectoryProperty getDirectory();

        ListProperty<String> getArguments();

        RegularFileProperty getOut();

        RegularFileProperty getErr();

        RegularFileProperty getStatus();
    }

    @Override
    public void execute() {
        Parameters it = getParameters();
        try (PrintWriter out = writer(it.getOut());
                PrintWriter err = writer(it.getErr())) {
            Path directory = it.getDirectory().get().getAsFile().toPath();
            String[] arguments = it.getArguments().get().toArray(String[]::new);
            Object status =
                    Class.forName(ENTRY)
                            .getMethod(
                                    "run",
                                    Path.class,
                                    PrintWriter.class,
                                    PrintWriter.class,
                                    String[].class)
                            .invoke(null, directory, out, err, arguments);
            Files.writeString(path(it.getStatus()), status.toString());
        } catch (ClassNotFoundException | NoSuchMethodException e) {
            throw new IllegalStateException(
                    "the dependencies of configuration 'arcomat' are not a tool that this plugin"
                            + " can call: they have no "
                            + ENTRY);
        } catch (IllegalAccessException | InvocationTargetException | IOException e) {
            throw new IllegalStateException("the tool could not be run: " + e, e);
        }
    }

    private static PrintWriter writer(RegularFileProperty file) throws IOException {
        return new PrintWriter(path(file).toFile(), StandardCharsets.UTF_8);
    }

    private static Path path(RegularFileProperty file) {
        return file.get().getAsFile().toPath();
    }
}

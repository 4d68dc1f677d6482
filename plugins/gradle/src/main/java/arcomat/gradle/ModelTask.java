package arcomat.gradle;

import org.gradle.api.file.ConfigurableFileCollection;
import org.gradle.api.file.FileTree;
import org.gradle.api.provider.ListProperty;
import org.gradle.api.provider.Provider;
import org.gradle.api.tasks.IgnoreEmptyDirectories;
import org.gradle.api.tasks.Input;
import org.gradle.api.tasks.InputFiles;
import org.gradle.api.tasks.PathSensitive;
import org.gradle.api.tasks.PathSensitivity;
import org.gradle.api.tasks.SkipWhenEmpty;

import java.util.ArrayList;
import java.util.List;

/** A task about models. */
public abstract class ModelTask extends ToolTask {
    /** The files of models and tests. */
    @InputFiles
    @IgnoreEmptyDirectories
    @PathSensitive(PathSensitivity.RELATIVE)
    public abstract ConfigurableFileCollection getModels();

    /** Those of them that the task is about: without any, it has nothing to do. */
    @InputFiles
    @SkipWhenEmpty
    @IgnoreEmptyDirectories
    @PathSensitive(PathSensitivity.RELATIVE)
    public FileTree getSubjects() {
        return getModels().getAsFileTree();
    }

    /** The model roots as texts name them: what is reported and generated names its model. */
    @Input
    public abstract ListProperty<String> getRoots();

    /** What to do with the models: a command without their names. */
    abstract List<String> command();

    /** Tells what came of it; an exception fails the task. */
    abstract void conclude(ToolResult result);

    /** Adds an option if the build has a value for it. */
    static void add(List<String> command, String option, Provider<?> value) {
        if (value.isPresent()) {
            command.addAll(List.of(option, value.get().toString()));
        }
    }

    @Override
    final List<List<String>> commands() {
        List<String> command = new ArrayList<>(command());
        getModels().getFiles().stream().map(this::shown).sorted().forEach(command::add);
        return List.of(command);
    }

    @Override
    final void conclude(List<ToolResult> results) {
        results.forEach(this::conclude);
    }
}

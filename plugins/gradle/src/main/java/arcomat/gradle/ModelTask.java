package arcomat.gradle;

import arcomat.plugin.ModelFiles;
import arcomat.plugin.ToolCommand;

import org.gradle.api.file.ConfigurableFileCollection;
import org.gradle.api.file.DirectoryProperty;
import org.gradle.api.file.FileTree;
import org.gradle.api.provider.ListProperty;
import org.gradle.api.provider.Provider;
import org.gradle.api.tasks.Classpath;
import org.gradle.api.tasks.IgnoreEmptyDirectories;
import org.gradle.api.tasks.Input;
import org.gradle.api.tasks.InputFiles;
import org.gradle.api.tasks.Optional;
import org.gradle.api.tasks.PathSensitive;
import org.gradle.api.tasks.PathSensitivity;
import org.gradle.api.tasks.SkipWhenEmpty;

import java.io.File;
import java.util.List;
import java.util.stream.Stream;

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

    /**
     * Folders with models of other projects, which these may refer to: model roots, of which
     * nothing is told or made here.
     */
    @InputFiles
    @Optional
    @IgnoreEmptyDirectories
    @PathSensitive(PathSensitivity.RELATIVE)
    public abstract DirectoryProperty getLibraries();

    /** Jars that bring laws and behaviour languages. */
    @Classpath
    public abstract ConfigurableFileCollection getGuests();

    /** What to do with the models: a command without their names. */
    abstract ToolCommand command();

    /** Tells what came of it; an exception fails the task. */
    abstract void conclude(ToolResult result);

    /** What the build says, if it says something. */
    static <T> java.util.Optional<T> said(Provider<T> value) {
        return java.util.Optional.ofNullable(value.getOrNull());
    }

    @Override
    final List<ToolCommand> commands() {
        return List.of(
                command()
                        .with("--with", shown(getGuests().getFiles().stream()))
                        .about(shown(getModels().getFiles().stream()), libraries()));
    }

    private List<String> libraries() {
        return getLibraries().isPresent()
                ? shown(ModelFiles.roots(getLibraries().get().getAsFile()).stream())
                : List.of();
    }

    private List<String> shown(Stream<File> files) {
        return files.map(this::shown).sorted().toList();
    }

    @Override
    final void conclude(List<ToolResult> results) {
        results.forEach(this::conclude);
    }
}

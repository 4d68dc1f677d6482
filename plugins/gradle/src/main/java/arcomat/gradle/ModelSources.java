package arcomat.gradle;

import arcomat.plugin.ModelFiles;

import org.gradle.api.Project;
import org.gradle.api.file.FileTree;
import org.gradle.api.file.SourceDirectorySet;
import org.gradle.api.plugins.ExtensionAware;
import org.gradle.api.tasks.SourceSet;

import java.io.File;
import java.nio.file.Path;
import java.util.List;

/**
 * The models of a source set, beside its Java: {@code src/main/arc}, or what the build script says
 * in {@code sourceSets.main.arc}.
 */
final class ModelSources {
    private static final String NAME = "arc";

    private final Project project;
    private final SourceDirectorySet directories;

    private ModelSources(Project project, SourceDirectorySet directories) {
        this.project = project;
        this.directories = directories;
    }

    /** Gives a source set its models. */
    static ModelSources of(SourceSet sourceSet, Project project) {
        SourceDirectorySet arc =
                project.getObjects()
                        .sourceDirectorySet(NAME, sourceSet.getName() + " component models");
        arc.srcDir("src/" + sourceSet.getName() + "/" + NAME);
        arc.include("**/*.arc", "**/*.ioautomaton", "**/*.maa", "**/*.cd", "**/*.mt");
        // As the tool does: hidden folders hold no models.
        arc.exclude("**/.*");
        // A model root may be the project's own folder, and what is built there is no source.
        arc.exclude(new Built(project.getLayout().getBuildDirectory()));
        ((ExtensionAware) sourceSet).getExtensions().add(SourceDirectorySet.class, NAME, arc);
        return new ModelSources(project, arc);
    }

    /** Makes a task read these models, besides those that it reads already. */
    void readBy(ModelTask task) {
        task.getModels().from(directories);
        task.getRoots().addAll(project.provider(this::roots));
    }

    /** What other projects may refer to, and what their robots need of it. */
    FileTree forOthers() {
        return directories.matching(files -> files.include(ModelFiles.MODELS)).plus(platformCode());
    }

    /** What is written by hand beside models, for targets. */
    FileTree platformCode() {
        return directories
                .getSourceDirectories()
                .getAsFileTree()
                .matching(files -> files.include("platform/**"));
    }

    /** The model roots, named from the folder of the whole build. */
    private List<String> roots() {
        Path directory = project.getRootDir().toPath();
        return directories.getSrcDirs().stream()
                .map(File::toPath)
                .map(root -> directory.relativize(root).toString())
                .toList();
    }
}

package arcomat.gradle;

import arcomat.plugin.ModelFiles;

import org.gradle.api.DefaultTask;
import org.gradle.api.file.ArchiveOperations;
import org.gradle.api.file.ConfigurableFileCollection;
import org.gradle.api.file.DirectoryProperty;
import org.gradle.api.file.FileSystemOperations;
import org.gradle.api.tasks.InputFiles;
import org.gradle.api.tasks.OutputDirectory;
import org.gradle.api.tasks.PathSensitive;
import org.gradle.api.tasks.PathSensitivity;
import org.gradle.api.tasks.SkipWhenEmpty;
import org.gradle.api.tasks.TaskAction;
import org.gradle.work.DisableCachingByDefault;

import java.io.File;

import javax.inject.Inject;

/** Makes a model root of each jar of models: a folder below the project's own, whoever made it. */
@DisableCachingByDefault(because = "It only copies.")
public abstract class UnpackModels extends DefaultTask {
    /** Jars, and folders that are model roots already. */
    @InputFiles
    @SkipWhenEmpty
    @PathSensitive(PathSensitivity.RELATIVE)
    public abstract ConfigurableFileCollection getArchives();

    /** A folder for each, which is named like it. */
    @OutputDirectory
    public abstract DirectoryProperty getOutput();

    @Inject
    protected abstract ArchiveOperations getArchiveOperations();

    @Inject
    protected abstract FileSystemOperations getFileSystem();

    @TaskAction
    final void unpack() {
        getFileSystem()
                .sync(
                        copy -> {
                            copy.into(getOutput());
                            copy.include(ModelFiles.MODELS);
                            copy.include(ModelFiles.PLATFORM);
                            copy.setIncludeEmptyDirs(false);
                            for (File each : getArchives()) {
                                String name = each.getName().replaceFirst("\\.jar$", "");
                                copy.from(content(each), files -> files.into(name));
                            }
                        });
    }

    private Object content(File archive) {
        return archive.isDirectory() ? archive : getArchiveOperations().zipTree(archive);
    }
}

package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.file.FileTree;
import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.tasks.CacheableTask;
import org.gradle.api.tasks.OutputFile;

/** Runs the stream tests of models; one that stays unknown fails as well. */
@CacheableTask
public abstract class TestArc extends ReportTask {
    /** Those that hold tests. */
    @Override
    public FileTree getSubjects() {
        return getModels().getAsFileTree().matching(files -> files.include("**/*.mt"));
    }

    /** The results, in the form that build servers read. */
    @OutputFile
    public abstract RegularFileProperty getJunitXml();

    @Override
    final ToolCommand question() {
        return ToolCommand.test();
    }

    @Override
    final String machineReport() {
        return "junit=" + shown(getJunitXml().get().getAsFile());
    }

    @Override
    final void praise(ToolResult result) {
        getLogger().info(result.out().stripTrailing());
    }
}

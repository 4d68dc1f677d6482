package arcomat.gradle;

import org.gradle.api.GradleException;
import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.provider.ListProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.Internal;
import org.gradle.api.tasks.OutputFile;
import org.gradle.api.tasks.UntrackedTask;
import org.gradle.api.tasks.options.Option;

import java.util.ArrayList;
import java.util.List;

/** Compares every component with what it was: fails where one breaks a promise without a reason. */
@UntrackedTask(because = "The models as they were are not a part of the project.")
public abstract class GateArc extends ReportTask {
    /** The model roots as they were, from the folder of the whole build: a checkout of main. */
    @Internal
    @Option(option = "base", description = "The model root as it was: a checkout of main.")
    public abstract ListProperty<String> getBase();

    /** After how many seconds to give up on a comparison; never if absent. */
    @Internal
    public abstract Property<Integer> getSeconds();

    /** A case for each component, in the form that build servers read. */
    @OutputFile
    public abstract RegularFileProperty getJunitXml();

    @Override
    final List<String> question() {
        if (getBase().get().isEmpty()) {
            throw new GradleException(
                    "compare with what? name the model root of another checkout:"
                            + " gateArc --base=../main/src/main/arc");
        }
        List<String> command = new ArrayList<>(List.of("gate"));
        getBase().get().forEach(each -> command.addAll(List.of("--base", each)));
        add(command, "--timeout", getSeconds());
        return command;
    }

    @Override
    final String machineReport() {
        return "junit=" + shown(getJunitXml().get().getAsFile());
    }

    @Override
    final void praise(ToolResult result) {
        getLogger().lifecycle(result.out().stripTrailing());
    }
}

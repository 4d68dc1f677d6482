package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.GradleException;
import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.provider.ListProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.Internal;
import org.gradle.api.tasks.OutputFile;
import org.gradle.api.tasks.UntrackedTask;
import org.gradle.api.tasks.options.Option;

/** Compares every component with what it was: fails where one breaks a promise without a reason. */
@UntrackedTask(because = "The models as they were are not a part of the project.")
public abstract class GateArc extends ReportTask {
    /** The model roots as they were, from the folder of the whole build: a checkout of main. */
    @Internal
    @Option(option = "base", description = "The model root as it was: a checkout of main.")
    public abstract ListProperty<String> getBase();

    /** Campaigns that have to hold as well, from the folder of the whole build. */
    @Internal
    @Option(option = "campaign", description = "A campaign that has to hold as well.")
    public abstract ListProperty<String> getCampaigns();

    /** The cluster whose workers make the runs of campaigns; threads of this machine if absent. */
    @Internal
    @Option(option = "cluster", description = "The cluster that makes the runs of campaigns.")
    public abstract Property<String> getCluster();

    /** Where workers of the cluster come; the tool's own address if absent. */
    @Internal
    @Option(option = "at", description = "HOST[:PORT] where workers of the cluster come.")
    public abstract Property<String> getAddress();

    /** A file with the secret of the cluster, if it has one. */
    @Internal
    @Option(option = "secret", description = "A file with the secret of the cluster.")
    public abstract Property<String> getSecret();

    /** Whether the robots of campaigns run on ideal bricks. */
    @Internal
    @Option(option = "no-limits", description = "Runs campaigns on ideal bricks.")
    public abstract Property<Boolean> getIdeal();

    /** After how many seconds to give up on a comparison; never if absent. */
    @Internal
    public abstract Property<Integer> getSeconds();

    /** A case for each component, in the form that build servers read. */
    @OutputFile
    public abstract RegularFileProperty getJunitXml();

    @Override
    final ToolCommand question() {
        if (getBase().get().isEmpty()) {
            throw new GradleException(
                    "compare with what? name the model root of another checkout:"
                            + " gateArc --base=../main/src/main/arc");
        }
        return ToolCommand.of("gate")
                .with("--base", getBase().get())
                .with("--campaign", getCampaigns().get())
                .with("--cluster", said(getCluster()))
                .with("--at", said(getAddress()))
                .with("--secret", said(getSecret()))
                .with("--no-limits", getIdeal().getOrElse(false))
                .with("--timeout", said(getSeconds()));
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

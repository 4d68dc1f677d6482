package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.GradleException;
import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.Internal;
import org.gradle.api.tasks.UntrackedTask;

/** Writes down what is found today, so that checks tell only what is new. */
@UntrackedTask(because = "Who starts it wants the file written anew.")
public abstract class BaselineArc extends ModelTask {
    /** What models must fulfil: {@code requirements} or {@code executable}. */
    @Internal
    public abstract Property<String> getProfile();

    /** The file to write, which is to be committed. */
    @Internal
    public abstract RegularFileProperty getBaseline();

    @Override
    final ToolCommand command() {
        if (!getBaseline().isPresent()) {
            throw new GradleException("say where: arcomat { baseline = file('known.txt') }");
        }
        String file = shown(getBaseline().get().getAsFile());
        return ToolCommand.of("check", "--profile", getProfile().get(), "--write-baseline", file);
    }

    @Override
    final void conclude(ToolResult result) {
        result.require(getLogger());
        getLogger().lifecycle(result.out().stripTrailing());
    }
}

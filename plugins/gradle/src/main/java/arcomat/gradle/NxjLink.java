package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.GradleException;
import org.gradle.api.file.DirectoryProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.Input;
import org.gradle.api.tasks.Optional;
import org.gradle.api.tasks.OutputDirectory;
import org.gradle.work.DisableCachingByDefault;

import java.io.File;
import java.util.List;

/** Makes programs for the brick of the jars of robots, with the linker of an installed leJOS. */
@DisableCachingByDefault(because = "The installation of leJOS is not an input.")
public abstract class NxjLink extends JarTask {
    /** The folder of leJOS NXJ. */
    @Input
    @Optional
    public abstract Property<String> getNxjHome();

    /** Where the programs go, {@code Robot.nxj} for {@code Robot.jar}. */
    @OutputDirectory
    public abstract DirectoryProperty getOutput();

    @Override
    final ToolCommand command(File jar) {
        if (!getNxjHome().isPresent()) {
            throw new GradleException(
                    "linking needs leJOS NXJ 0.9.1: install it, and set NXJ_HOME, or nxjHome in"
                            + " arcomat { .. }, to its folder");
        }
        String name = jar.getName().replaceFirst("\\.jar$", ".nxj");
        String program = shown(getOutput().file(name).get().getAsFile());
        return ToolCommand.of(
                "link", "--jar", shown(jar), "--out", program, "--nxj-home", getNxjHome().get());
    }

    @Override
    final void conclude(List<ToolResult> results) {
        for (ToolResult result : results) {
            result.requireOutput(getLogger());
            getLogger().lifecycle(result.summary());
        }
    }
}

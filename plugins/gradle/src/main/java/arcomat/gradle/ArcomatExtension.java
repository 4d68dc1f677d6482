package arcomat.gradle;

import org.gradle.api.file.DirectoryProperty;
import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.provider.ListProperty;
import org.gradle.api.provider.Property;

/** What a build script says in {@code arcomat { .. }}; everything has a default. */
public abstract class ArcomatExtension {
    /** The tool's version; the plugin's own if absent. */
    public abstract Property<String> getToolVersion();

    /**
     * The component to generate and to simulate, such as {@code coffee.fetcher.Fetcher}; without
     * it, code is generated for all.
     */
    public abstract Property<String> getMain();

    /** What {@code assemble} makes: {@code jvm}, {@code lejos}, or both; {@code jvm} if absent. */
    public abstract ListProperty<String> getTargets();

    /**
     * What generated code and simulations do where a model leaves a choice: {@code first}, which is
     * the default, or {@code random}.
     */
    public abstract Property<String> getChoose();

    /** What models must fulfil: {@code requirements}, the default, or {@code executable}. */
    public abstract Property<String> getProfile();

    /** Whether warnings fail the build; they do not if absent. */
    public abstract Property<Boolean> getWarningsFail();

    /** Findings that are known, which {@code baselineArc} writes; none if absent. */
    public abstract RegularFileProperty getBaseline();

    /** The folder of leJOS NXJ; that of the environment's {@code NXJ_HOME} if absent. */
    public abstract DirectoryProperty getNxjHome();

    /** How much memory the tool's process may use, such as {@code 2g}; 1g if absent. */
    public abstract Property<String> getMaxHeapSize();
}

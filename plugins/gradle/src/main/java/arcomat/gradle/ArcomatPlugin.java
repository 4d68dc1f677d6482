package arcomat.gradle;

import org.gradle.api.Plugin;
import org.gradle.api.Project;
import org.gradle.api.artifacts.Configuration;
import org.gradle.api.artifacts.Dependency;
import org.gradle.api.plugins.JavaPlugin;
import org.gradle.api.plugins.JavaPluginExtension;
import org.gradle.api.provider.Provider;
import org.gradle.api.tasks.SourceSet;
import org.gradle.api.tasks.SourceSetContainer;
import org.gradle.util.GradleVersion;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** {@code plugins { id 'arcomat' }}: models are checked, tested, verified and compiled. */
public final class ArcomatPlugin implements Plugin<Project> {
    static final String NAME = "arcomat";

    private static final String RUNTIME = "arcomatRuntime";

    @Override
    public void apply(Project project) {
        GradleRange.require(GradleVersion.current());
        project.getPluginManager().apply(JavaPlugin.class);
        ArcomatExtension settings = settings(project);
        Configuration tool = tool(project, settings);
        runtime(project, settings);

        SourceSetContainer sourceSets =
                project.getExtensions().getByType(JavaPluginExtension.class).getSourceSets();
        SourceSet java = sourceSets.getByName(SourceSet.MAIN_SOURCE_SET_NAME);
        ModelSources main = ModelSources.of(java, project);
        ModelSources test =
                ModelSources.of(sourceSets.getByName(SourceSet.TEST_SOURCE_SET_NAME), project);

        project.getTasks()
                .withType(ToolTask.class)
                .configureEach(
                        task -> {
                            task.setGroup(NAME);
                            task.getTool().from(tool);
                            task.getDirectory().set(project.getRootDir());
                            task.getMaxHeapSize().convention(settings.getMaxHeapSize());
                        });
        new ModelLibraries(project).register(main);
        new ModelTasks(project, settings, main, test).register();
        new CodeTasks(project, settings, main).register(java);
    }

    private static ArcomatExtension settings(Project project) {
        ArcomatExtension settings = project.getExtensions().create(NAME, ArcomatExtension.class);
        settings.getToolVersion().convention(ownVersion());
        settings.getTargets().convention(List.of(Targets.JVM));
        settings.getChoose().convention("first");
        settings.getProfile().convention("requirements");
        settings.getWarningsFail().convention(false);
        settings.getMaxHeapSize().convention("1g");
        Provider<File> nxjHome =
                project.getProviders()
                        .environmentVariable("NXJ_HOME")
                        .map(path -> path.isBlank() ? null : new File(path));
        settings.getNxjHome().convention(project.getLayout().dir(nxjHome));
        return settings;
    }

    /** The tool; a build that takes it from elsewhere adds a dependency of its own. */
    private static Configuration tool(Project project, ArcomatExtension settings) {
        Configuration tool = project.getConfigurations().create(NAME);
        tool.setDescription("The tool that the tasks run.");
        tool.setVisible(false);
        tool.setCanBeConsumed(false);
        tool.defaultDependencies(all -> all.add(dependency(project, settings, "arcomat:arcomat")));
        return tool;
    }

    /** What code for the JVM needs to be compiled and to run. */
    private static void runtime(Project project, ArcomatExtension settings) {
        Configuration runtime = project.getConfigurations().create(RUNTIME);
        runtime.setDescription("What generated code needs.");
        runtime.setVisible(false);
        runtime.setCanBeConsumed(false);
        runtime.setCanBeResolved(false);
        runtime.defaultDependencies(
                all -> {
                    if (Targets.contain(settings.getTargets().get(), Targets.JVM)) {
                        all.add(dependency(project, settings, "arcomat:arcomat-runtime"));
                    }
                });
        project.getConfigurations()
                .named(JavaPlugin.IMPLEMENTATION_CONFIGURATION_NAME)
                .configure(implementation -> implementation.extendsFrom(runtime));
    }

    private static Dependency dependency(
            Project project, ArcomatExtension settings, String module) {
        return project.getDependencies().create(module + ":" + settings.getToolVersion().get());
    }

    private static String ownVersion() {
        try (InputStream in = ArcomatPlugin.class.getResourceAsStream("version.txt")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).strip();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}

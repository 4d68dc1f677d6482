package arcomat.gradle;

import org.gradle.api.Plugin;
import org.gradle.api.Project;
import org.gradle.api.artifacts.Configuration;
import org.gradle.api.artifacts.Dependency;
import org.gradle.api.plugins.JavaPlugin;
import org.gradle.api.plugins.JavaPluginExtension;
import org.gradle.api.tasks.SourceSet;
import org.gradle.api.tasks.SourceSetContainer;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** {@code plugins { id 'arcomat' }}: models are checked, tested, verified and compiled. */
public final class ArcomatPlugin implements Plugin<Project> {
    private static final String NAME = "arcomat";

    @Override
    public void apply(Project project) {
        project.getPluginManager().apply(JavaPlugin.class);
        ArcomatExtension settings = settings(project);
        Configuration tool = toolConfiguration(project, settings);

        SourceSetContainer sourceSets =
                project.getExtensions().getByType(JavaPluginExtension.class).getSourceSets();
        ModelSources main =
                ModelSources.of(sourceSets.getByName(SourceSet.MAIN_SOURCE_SET_NAME), project);
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
        new ArcomatTasks(project, settings, main, test).register();
    }

    private static ArcomatExtension settings(Project project) {
        ArcomatExtension settings = project.getExtensions().create(NAME, ArcomatExtension.class);
        settings.getToolVersion().convention(ownVersion());
        settings.getTargets().convention(List.of("jvm"));
        settings.getChoose().convention("first");
        settings.getProfile().convention("requirements");
        settings.getWarningsFail().convention(false);
        settings.getMaxHeapSize().convention("1g");
        return settings;
    }

    /** The tool, for builds that want another one to be told so as any dependency is. */
    private static Configuration toolConfiguration(Project project, ArcomatExtension settings) {
        return project.getConfigurations()
                .create(
                        NAME,
                        configuration -> {
                            configuration.setDescription("The tool that the tasks run.");
                            configuration.setVisible(false);
                            configuration.setCanBeConsumed(false);
                            configuration.defaultDependencies(
                                    all -> all.add(toolOf(project, settings)));
                        });
    }

    private static Dependency toolOf(Project project, ArcomatExtension settings) {
        return project.getDependencies()
                .create("arcomat:arcomat:" + settings.getToolVersion().get());
    }

    private static String ownVersion() {
        try (InputStream in = ArcomatPlugin.class.getResourceAsStream("version.txt")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).strip();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}

package arcomat.gradle;

import org.gradle.api.Project;
import org.gradle.api.file.Directory;
import org.gradle.api.provider.Provider;
import org.gradle.api.tasks.TaskContainer;
import org.gradle.api.tasks.TaskProvider;
import org.gradle.language.base.plugins.LifecycleBasePlugin;

import java.util.ArrayList;
import java.util.List;

/** The tasks of a project with models, and their places in its build. */
final class ArcomatTasks {
    private final Project project;
    private final ArcomatExtension settings;
    private final ModelSources main;
    private final ModelSources test;
    private final TaskContainer tasks;

    ArcomatTasks(Project project, ArcomatExtension settings, ModelSources main, ModelSources test) {
        this.project = project;
        this.settings = settings;
        this.main = main;
        this.test = test;
        this.tasks = project.getTasks();
    }

    void register() {
        partOfCheck(
                tasks.register(
                        "checkArc",
                        CheckArc.class,
                        task -> {
                            task.setDescription("Reports what is wrong with the models.");
                            readAll(task);
                            task.getProfile().convention(settings.getProfile());
                            task.getWarningsFail().convention(settings.getWarningsFail());
                            task.getReport().convention(reports().map(d -> d.file("check.txt")));
                        }));
    }

    /** The models of main and test: tests see what they test. */
    private void readAll(ModelTask task) {
        task.getModels().from(main.models(), test.models());
        task.getRoots()
                .set(
                        project.provider(
                                () -> {
                                    List<String> roots = new ArrayList<>(main.roots());
                                    roots.addAll(test.roots());
                                    return roots;
                                }));
    }

    private Provider<Directory> reports() {
        return project.getLayout().getBuildDirectory().dir("reports/arcomat");
    }

    private void partOfCheck(TaskProvider<?> task) {
        tasks.named(LifecycleBasePlugin.CHECK_TASK_NAME).configure(check -> check.dependsOn(task));
    }
}

package arcomat.gradle;

import org.gradle.api.Project;
import org.gradle.api.file.Directory;
import org.gradle.api.provider.Provider;
import org.gradle.api.tasks.TaskContainer;
import org.gradle.api.tasks.TaskProvider;
import org.gradle.language.base.plugins.LifecycleBasePlugin;

/** Tasks about all models of a project: those of main, and those of test, which see the others. */
final class ModelTasks {
    private final ArcomatExtension settings;
    private final ModelSources main;
    private final ModelSources test;
    private final TaskContainer tasks;
    private final Provider<Directory> build;

    ModelTasks(Project project, ArcomatExtension settings, ModelSources main, ModelSources test) {
        this.settings = settings;
        this.main = main;
        this.test = test;
        this.tasks = project.getTasks();
        this.build = project.getLayout().getBuildDirectory();
    }

    void register() {
        tasks.withType(ReportTask.class).configureEach(this::reportToFile);
        partOfCheck(checkArc());
        partOfCheck(verifyArc());
        partOfCheck(testArc());
        register("formatArc", FormatArc.class, "Rewrites the models in canonical form.");
        register("checkArcFormat", CheckArcFormat.class, "Fails when a model is not formatted.");
        simulateArc();
    }

    private TaskProvider<CheckArc> checkArc() {
        TaskProvider<CheckArc> provider =
                register("checkArc", CheckArc.class, "Reports what is wrong with the models.");
        provider.configure(
                task -> {
                    task.getProfile().convention(settings.getProfile());
                    task.getWarningsFail().convention(settings.getWarningsFail());
                });
        return provider;
    }

    private TaskProvider<VerifyArc> verifyArc() {
        return register("verifyArc", VerifyArc.class, "Proves all that the models say they keep.");
    }

    private TaskProvider<TestArc> testArc() {
        TaskProvider<TestArc> provider =
                register("testArc", TestArc.class, "Runs the stream tests of the models.");
        provider.configure(
                task ->
                        task.getJunitXml()
                                .convention(
                                        build.map(
                                                d -> d.file("test-results/testArc/TEST-arc.xml"))));
        return provider;
    }

    private void simulateArc() {
        register("simulateArc", SimulateArc.class, "Runs a component and prints what happened.")
                .configure(
                        task -> {
                            task.getMain().convention(settings.getMain());
                            task.getChoose().convention(settings.getChoose());
                        });
    }

    private <T extends ModelTask> TaskProvider<T> register(
            String name, Class<T> type, String description) {
        return tasks.register(
                name,
                type,
                task -> {
                    task.setDescription(description);
                    main.readBy(task);
                    test.readBy(task);
                });
    }

    private void reportToFile(ReportTask task) {
        String file = "reports/arcomat/" + task.getName() + ".txt";
        task.getReport().convention(build.map(directory -> directory.file(file)));
    }

    private void partOfCheck(TaskProvider<?> task) {
        tasks.named(LifecycleBasePlugin.CHECK_TASK_NAME).configure(check -> check.dependsOn(task));
    }
}

package arcomat.gradle;

import org.gradle.api.Project;
import org.gradle.api.file.Directory;
import org.gradle.api.file.RegularFile;
import org.gradle.api.provider.Provider;
import org.gradle.api.tasks.TaskContainer;
import org.gradle.api.tasks.TaskProvider;
import org.gradle.language.base.plugins.LifecycleBasePlugin;

/** Tasks about all models of a project: those of main, and those of test, which see the others. */
final class ModelTasks {
    static final String CHECK = "checkArc";

    private final ArcomatExtension settings;
    private final ModelSources main;
    private final ModelSources test;
    private final TaskContainer tasks;
    private final Provider<Directory> build;
    private final Provider<String> logFormat;

    ModelTasks(Project project, ArcomatExtension settings, ModelSources main, ModelSources test) {
        this.settings = settings;
        this.main = main;
        this.test = test;
        this.tasks = project.getTasks();
        this.build = project.getLayout().getBuildDirectory();
        this.logFormat =
                project.getProviders()
                        .environmentVariable("GITHUB_ACTIONS")
                        .map("true"::equals)
                        .orElse(false)
                        .map(github -> github ? "github" : "text");
    }

    void register() {
        tasks.withType(ReportTask.class)
                .configureEach(
                        task -> {
                            task.getReport().convention(report(task, "txt"));
                            task.getLogFormat().convention(logFormat);
                        });
        partOfCheck(checkArc());
        partOfCheck(verifyArc());
        partOfCheck(testArc());
        register("formatArc", FormatArc.class, "Rewrites the models in canonical form.");
        register("checkArcFormat", CheckArcFormat.class, "Fails when a model is not formatted.")
                .configure(task -> task.getReport().convention(report(task, "txt")));
        baselineArc();
        simulateArc();
        gateArc();
    }

    private TaskProvider<CheckArc> checkArc() {
        TaskProvider<CheckArc> provider =
                register(CHECK, CheckArc.class, "Reports what is wrong with the models.");
        provider.configure(
                task -> {
                    task.getProfile().convention(settings.getProfile());
                    task.getWarningsFail().convention(settings.getWarningsFail());
                    task.getBaseline().convention(settings.getBaseline());
                    task.getSarif().convention(report(task, "sarif"));
                    task.getMemory()
                            .convention(build.map(folder -> folder.file("arcomat/checkArc.state")));
                });
        return provider;
    }

    private TaskProvider<VerifyArc> verifyArc() {
        TaskProvider<VerifyArc> provider =
                register("verifyArc", VerifyArc.class, "Proves all that the models say they keep.");
        provider.configure(task -> task.getSarif().convention(report(task, "sarif")));
        return provider;
    }

    private TaskProvider<TestArc> testArc() {
        TaskProvider<TestArc> provider =
                register("testArc", TestArc.class, "Runs the stream tests of the models.");
        provider.configure(task -> task.getJunitXml().convention(junitXml(task)));
        return provider;
    }

    private void baselineArc() {
        register("baselineArc", BaselineArc.class, "Writes down what is found today as known.")
                .configure(
                        task -> {
                            task.getProfile().convention(settings.getProfile());
                            task.getBaseline().convention(settings.getBaseline());
                        });
    }

    private void simulateArc() {
        register("simulateArc", SimulateArc.class, "Runs a component and prints what happened.")
                .configure(
                        task -> {
                            task.getMain().convention(settings.getMain());
                            task.getChoose().convention(settings.getChoose());
                        });
    }

    private void gateArc() {
        tasks.register(
                "gateArc",
                GateArc.class,
                task -> {
                    task.setDescription("Compares the models with what they were on main.");
                    main.readBy(task);
                    task.getJunitXml().convention(junitXml(task));
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
                    if (!name.equals(CHECK)) {
                        task.mustRunAfter(tasks.named(CHECK)); // which tells what is wrong, once
                    }
                });
    }

    private Provider<RegularFile> junitXml(ModelTask task) {
        String file = "test-results/" + task.getName() + "/TEST-arc.xml";
        return build.map(folder -> folder.file(file));
    }

    private Provider<RegularFile> report(ModelTask task, String ending) {
        String file = "reports/arcomat/" + task.getName() + "." + ending;
        return build.map(folder -> folder.file(file));
    }

    private void partOfCheck(TaskProvider<?> task) {
        tasks.named(LifecycleBasePlugin.CHECK_TASK_NAME).configure(check -> check.dependsOn(task));
    }
}

package arcomat.gradle;

import org.gradle.api.Project;
import org.gradle.api.file.Directory;
import org.gradle.api.file.FileTree;
import org.gradle.api.provider.Provider;
import org.gradle.api.tasks.SourceSet;
import org.gradle.api.tasks.Sync;
import org.gradle.api.tasks.TaskContainer;
import org.gradle.api.tasks.TaskProvider;
import org.gradle.api.tasks.compile.JavaCompile;
import org.gradle.language.base.plugins.LifecycleBasePlugin;

import java.io.File;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Tasks that make code of the models of main, and robots of the code. */
final class CodeTasks {
    private final Project project;
    private final ArcomatExtension settings;
    private final ModelSources main;
    private final TaskContainer tasks;
    private final Provider<Directory> build;

    CodeTasks(Project project, ArcomatExtension settings, ModelSources main) {
        this.project = project;
        this.settings = settings;
        this.main = main;
        this.tasks = project.getTasks();
        this.build = project.getLayout().getBuildDirectory();
    }

    /**
     * Registers the tasks.
     *
     * @param java what code for the JVM becomes a part of
     */
    void register(SourceSet java) {
        tasks.withType(GenerateArc.class).configureEach(this::generate);
        TaskProvider<GenerateArc> jvm = generateArc("generateArcJvm", Targets.JVM);
        java.getJava().srcDir(ifWanted(Targets.JVM, jvm));
        tasks.named(java.getCompileJavaTaskName(), JavaCompile.class, CodeTasks::readUtf8);

        TaskProvider<GenerateArc> lejos = generateArc("generateArcLejos", Targets.LEJOS);
        TaskProvider<Sync> jars = nxtJar(lejos);
        addTo(LifecycleBasePlugin.ASSEMBLE_TASK_NAME, ifWanted(Targets.LEJOS, jars));
        addTo(
                LifecycleBasePlugin.CHECK_TASK_NAME,
                ifWanted(Targets.LEJOS, brickCheck(robots(jars))));
        nxjLink(robots(jars));
    }

    /** Generated code is UTF-8, like the models, wherever it is compiled. */
    private static void readUtf8(JavaCompile task) {
        task.getOptions().setEncoding(StandardCharsets.UTF_8.name());
    }

    private void generate(GenerateArc task) {
        main.readBy(task);
        task.mustRunAfter(tasks.named(ModelTasks.CHECK)); // which tells what is wrong, once
        task.getPlatformCode().from(main.platformCode());
        task.getMain().convention(settings.getMain());
        task.getChoose().convention(settings.getChoose());
        String folder = "generated/sources/arcomat/" + task.getName();
        task.getOutput().convention(build.map(directory -> directory.dir(folder)));
    }

    private TaskProvider<GenerateArc> generateArc(String name, String target) {
        return tasks.register(
                name,
                GenerateArc.class,
                task -> {
                    task.setDescription("Writes code for target " + target + ".");
                    task.getTarget().convention(target);
                });
    }

    private TaskProvider<Sync> nxtJar(TaskProvider<GenerateArc> lejos) {
        return tasks.register(
                "nxtJar",
                Sync.class,
                task -> {
                    task.setGroup(ArcomatPlugin.NAME);
                    task.setDescription("Makes a jar of each component that is deployed.");
                    task.from(lejos, files -> files.include("*.jar"));
                    task.into(build.map(directory -> directory.dir("nxt")));
                });
    }

    /** The jars, whoever made them. */
    private FileTree robots(TaskProvider<Sync> jars) {
        return project.files(jars).getAsFileTree().matching(files -> files.include("*.jar"));
    }

    private TaskProvider<BrickCheck> brickCheck(FileTree robots) {
        return tasks.register(
                "brickCheck",
                BrickCheck.class,
                task -> {
                    task.setDescription("Reports what each jar needs on the brick.");
                    task.getJars().from(robots);
                    task.getReport()
                            .convention(build.map(d -> d.file("reports/arcomat/brickCheck.txt")));
                });
    }

    private void nxjLink(FileTree robots) {
        tasks.register(
                "nxjLink",
                NxjLink.class,
                task -> {
                    task.setDescription("Links each jar for the brick, with an installed leJOS.");
                    task.getJars().from(robots);
                    task.getNxjHome()
                            .convention(
                                    settings.getNxjHome()
                                            .map(Directory::getAsFile)
                                            .map(File::getPath));
                    task.getOutput().convention(build.map(directory -> directory.dir("nxj")));
                });
    }

    /** A task where a build wants the target, else nothing; asked when the build is complete. */
    private Provider<Object> ifWanted(String target, TaskProvider<?> task) {
        return settings.getTargets()
                .flatMap(
                        targets ->
                                Targets.contain(targets, target)
                                        ? task.map(Object.class::cast)
                                        : project.provider(List::of));
    }

    private void addTo(String lifecycle, Provider<Object> task) {
        tasks.named(lifecycle).configure(it -> it.dependsOn(task));
    }
}

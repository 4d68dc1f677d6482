package arcomat.generate.project;

import arcomat.generate.GeneratedFile;
import arcomat.generate.template.ShippedTemplates;

import java.util.ArrayList;
import java.util.List;

/** The files of a new project: models, their tests, a build, and what to try next. */
public final class ProjectFiles {
    private static final String FOLDER = "project";

    private final ProjectName name;
    private final ProjectView view;
    private final List<GeneratedFile> files = new ArrayList<>();

    private ProjectFiles(ProjectName name, ProjectView view) {
        this.name = name;
        this.view = view;
    }

    /**
     * All of them, relative to the project's folder.
     *
     * @param name which is fine
     * @param version of the tool
     * @param robot whether there is a robot around the logic
     * @param campaign whether there are two robots, and many runs
     */
    public static List<GeneratedFile> of(
            ProjectName name, String version, boolean robot, boolean campaign) {
        ProjectView view =
                new ProjectView(
                        name.text(),
                        name.component(),
                        name.packageName(),
                        version,
                        robot,
                        campaign);
        ProjectFiles project = new ProjectFiles(name, view);
        project.addBuild();
        project.addModels();
        if (robot) {
            project.addRobot();
        }
        if (campaign) {
            project.add(name.text() + ".campaign", "campaign.ftl");
        }
        return List.copyOf(project.files);
    }

    private void addBuild() {
        add("README.md", "readme.ftl");
        add("build.gradle", "build-gradle.ftl");
        add("settings.gradle", "settings-gradle.ftl");
        add(".gitignore", "gitignore.ftl");
        add(".gitattributes", "gitattributes.ftl");
        add(".github/workflows/models.yml", "workflow.ftl");
    }

    private void addModels() {
        addModel("main", "Signals.cd", "signals.ftl");
        addModel("main", "Promise.arc", "promise.ftl");
        addModel("main", "Pilot.arc", "pilot.ftl");
        addModel("test", "PilotTest.mt", "pilot-test.ftl");
    }

    private void addRobot() {
        addModel("main", "Wheels.arc", "wheels.ftl");
        addModel("main", ".arc", "robot.ftl");
        add(name.text() + ".world", "world.ftl");
    }

    private void addModel(String sourceSet, String ending, String template) {
        String folder = "src/" + sourceSet + "/arc/" + name.packageName() + "/";
        add(folder + name.component() + ending, template);
    }

    private void add(String path, String template) {
        String text = ShippedTemplates.render(FOLDER, template, view);
        files.add(new GeneratedFile(path, text));
    }
}

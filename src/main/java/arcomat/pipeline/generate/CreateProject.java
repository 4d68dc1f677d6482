package arcomat.pipeline.generate;

import arcomat.generate.GeneratedFile;
import arcomat.generate.project.ProjectFiles;
import arcomat.generate.project.ProjectName;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.FileFinder;
import arcomat.pipeline.file.NewFolder;
import arcomat.source.SourceFile;
import arcomat.syntax.Parser;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Makes a folder for somebody who begins: models that check, tests that pass, a build.
 *
 * @param name of the folder, of the package in it and of the robot
 * @param kind what is in it
 * @param version of the tool, which the build asks for
 */
public record CreateProject(String name, Kind kind, String version)
        implements Task<CreateProject.Created> {

    /** What somebody begins with. */
    public enum Kind {
        /** One that drives on a floor. */
        robot,

        /** Logic without a robot around it. */
        component,

        /** Two robots on one floor, and a campaign. */
        world
    }

    /**
     * What was made.
     *
     * @param files how many
     * @param next commands to go on with, from the folder that the project lies in
     */
    public record Created(int files, List<String> next) {}

    /**
     * @throws WrongUse where the name is none, or somebody else's files are in the way
     */
    @Override
    public Created run(Session session) throws WrongUse {
        ProjectName project = new ProjectName(name);
        Map<String, String> files = project.isFine() ? files(project) : Map.of();
        if (files.isEmpty() || !areReadable(files)) {
            throw new WrongUse(
                    "'%s' cannot be the name of a package and of a component: letters and digits,"
                            + " a letter first, no word of the language, and not that of a"
                            + " library; did you mean '%s'?",
                    name, project.suggestion());
        }
        NewFolder.create(name, files, session.names());
        return new Created(files.size(), next(project));
    }

    private Map<String, String> files(ProjectName project) {
        boolean robot = kind != Kind.component;
        Map<String, String> files = new LinkedHashMap<>();
        for (GeneratedFile file : ProjectFiles.of(project, version, robot, kind == Kind.world)) {
            files.put(file.path(), file.text());
        }
        return files;
    }

    /** Some words of the language are names as well, others are not: the parser knows. */
    private static boolean areReadable(Map<String, String> files) {
        return files.entrySet().stream()
                .filter(file -> FileFinder.isModelFile(Path.of(file.getKey())))
                .map(file -> Parser.parse(new SourceFile(file.getKey(), file.getValue())))
                .allMatch(parsed -> parsed.findings().isEmpty());
    }

    private List<String> next(ProjectName project) {
        String test = "arcomat test " + name;
        String world = "arcomat world " + name + "/" + name + ".world";
        return switch (kind) {
            case robot -> List.of(test, "arcomat verify " + name, world);
            case component ->
                    List.of(
                            test,
                            "arcomat verify " + name,
                            "arcomat simulate --main " + project.logic() + " " + name);
            case world ->
                    List.of(test, world, "arcomat campaign " + name + "/" + name + ".campaign");
        };
    }
}

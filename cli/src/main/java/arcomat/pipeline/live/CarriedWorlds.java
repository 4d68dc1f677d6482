package arcomat.pipeline.live;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.FileFinder;
import arcomat.pipeline.file.FileFinder.Found;
import arcomat.pipeline.file.FileReader;
import arcomat.source.SourceFile;
import arcomat.world.Kind.Program.Form;
import arcomat.world.WorldParser;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * The worlds that a page carries, and the paths of the models that it needs.
 *
 * @param models as the user wrote them, and those that the robots of the worlds run
 */
record CarriedWorlds(List<SourceFile> worlds, List<String> models) {
    private static final String ENDING = ".world";

    CarriedWorlds {
        worlds = List.copyOf(worlds);
        models = List.copyOf(models);
    }

    /**
     * Worlds that are named, or lie below folders that are.
     *
     * @throws WrongUse where one cannot be read
     */
    static CarriedWorlds find(List<String> paths, PathNames names) throws WrongUse {
        List<String> models = new ArrayList<>();
        FileFinder finder = new FileFinder(names, List.of(ENDING), "world");
        for (String path : paths) {
            if (path.endsWith(ENDING)) {
                requireFound(path, finder);
            } else {
                models.add(path);
                searchFolder(path, finder, names);
            }
        }
        List<SourceFile> worlds = new ArrayList<>();
        for (Found found : finder.files()) {
            SourceFile world = FileReader.text(found.path(), found.shown());
            worlds.add(world);
            addModels(world, found, models, names);
        }
        return new CarriedWorlds(worlds, models);
    }

    private static void requireFound(String path, FileFinder finder) throws WrongUse {
        int before = finder.findings().size();
        finder.find(path);
        if (finder.findings().size() > before) {
            throw new WrongUse("%s", finder.findings().get(before).message());
        }
    }

    /**
     * One without a world is as good; what is wrong with it is told when it is searched for models.
     */
    private static void searchFolder(String path, FileFinder finder, PathNames names) {
        if (Files.isDirectory(names.resolve(path))) {
            finder.find(path);
        }
    }

    private static void addModels(
            SourceFile world, Found found, List<String> models, PathNames names) {
        Path folder = Objects.requireNonNull(found.path().getParent());
        WorldParser.parse(world).programs().stream()
                .filter(program -> program.form() == Form.COMPONENT)
                .map(program -> folder.resolve(program.folder()).normalize())
                .filter(root -> Files.isDirectory(root) && !isBelow(root, models, names))
                .distinct()
                .forEach(
                        root -> models.add(names.shown(root, Path.of(found.shown()).isAbsolute())));
    }

    private static boolean isBelow(Path root, List<String> models, PathNames names) {
        return models.stream()
                .map(path -> PathNames.real(names.resolve(path)))
                .anyMatch(PathNames.real(root)::startsWith);
    }
}

package arcomat.editor.name;

import arcomat.editor.desk.Desk;
import arcomat.editor.desk.View;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.file.FileFinder;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** All models of this repository, those with mistakes too, as an editor has them. */
final class ShippedModels {
    private static final List<Path> FOLDERS =
            Stream.of("models", "lejos-runtime/nxt/src/main/arc", "src/test/resources")
                    .map(folder -> Path.of(folder).toAbsolutePath())
                    .toList();

    private final Desk desk = new Desk();

    private ShippedModels() {
        FOLDERS.forEach(desk::add);
    }

    static ShippedModels checked() {
        ShippedModels models = new ShippedModels();
        models.desk.check(() -> {});
        return models;
    }

    Desk desk() {
        return desk;
    }

    /** A view of each file that can be read, in the order of paths. */
    List<View> views() {
        return FOLDERS.stream()
                .flatMap(ShippedModels::files)
                .flatMap(file -> desk.view(file).stream())
                .toList();
    }

    private static Stream<Path> files(Path folder) {
        FileFinder finder = new FileFinder(new PathNames(folder));
        finder.find(folder.toString());
        return finder.files().stream().map(FileFinder.Found::path).sorted();
    }
}

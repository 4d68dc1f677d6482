package arcomat.pipeline.recheck;

import arcomat.guest.host.Guests;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.check.ModelRoot;
import arcomat.pipeline.file.FileReader;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.Parsed;
import arcomat.tree.Unit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The files that one refers to, over some steps. Those beyond count as files that cannot be read:
 * what they define is excused.
 */
final class Reach {
    /** Files to be read; somebody waits. */
    private static final int MOST = 30;

    private final Guests guests;
    private final LibraryModels libraries;
    private final Path root;
    private final PathNames names;
    private final ModelRoot roots;
    private final Set<Path> met = new HashSet<>();

    /**
     * @param root the folder of the models, absolute
     * @param guests who bring laws and behaviour languages
     * @param libraries models of others that the file may refer to
     */
    Reach(Path root, Guests guests, LibraryModels libraries) {
        this.guests = guests;
        this.libraries = libraries;
        this.root = root;
        this.names = new PathNames(root);
        this.roots = new ModelRoot(names.fence());
    }

    /** Nothing where the file's package does not say that its root is this one. */
    Optional<OpenModels> of(SourceFile text) {
        met.add(root.resolve(text.path()));
        OpenModels models =
                OpenModels.in(root, false, guests)
                        .referringTo(libraries)
                        .with(OpenModels.Edit.of(List.of(text)));
        List<Unit> fresh = readable(models, List.of(text));
        if (!fresh.stream().allMatch(this::belongsHere)) {
            return Optional.empty();
        }
        while (!fresh.isEmpty()) {
            OpenModels.Edit more = neededBy(fresh);
            models = models.with(more);
            fresh = readable(models, more.written());
        }
        return Optional.of(models);
    }

    private boolean belongsHere(Unit unit) {
        return ModelRoot.of(unit, place(unit)).filter(root::equals).isPresent();
    }

    private Path place(Unit unit) {
        return root.resolve(unit.file().path());
    }

    private static List<Unit> readable(OpenModels models, List<SourceFile> texts) {
        return texts.stream()
                .flatMap(each -> models.parsed(each.path()).stream())
                .map(Parsed::readable)
                .flatMap(Optional::stream)
                .toList();
    }

    private OpenModels.Edit neededBy(List<Unit> units) {
        List<SourceFile> written = new ArrayList<>();
        List<Diagnostic> unreadable = new ArrayList<>();
        for (Unit unit : units) {
            for (Path file : roots.neededBy(unit, place(unit), root)) {
                if (met.add(file)) {
                    FileReader.Read read = read(file, names.shown(file, false));
                    read.file().ifPresent(written::add);
                    read.finding().ifPresent(unreadable::add);
                }
            }
        }
        return new OpenModels.Edit(written, unreadable, Set.of());
    }

    private FileReader.Read read(Path file, String path) {
        return met.size() > MOST ? FileReader.unread(path) : FileReader.read(file, path);
    }
}

package arcomat.pipeline.recheck;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.check.Library;
import arcomat.pipeline.check.ModelRoot;
import arcomat.source.Sha256;
import arcomat.tree.Unit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** The files around those that the user named, as far as these refer to them. */
final class FilesAround {
    private final PathNames names;
    private final Set<Path> searched;
    private final Set<Path> named = new HashSet<>();
    private final Set<Path> places = new HashSet<>();
    private final ModelRoot roots;
    private final Library library = new Library();
    private final Map<Path, Path> real = new HashMap<>();

    /**
     * @param searched folders whose files are all named, with their real names
     * @param files those that the user named
     */
    FilesAround(PathNames names, Set<Path> searched, Collection<String> files) {
        this.names = names;
        this.roots = new ModelRoot(names.fence());
        this.searched = searched;
        files.forEach(file -> places.add(place(file)));
    }

    /** The files that a unit refers to and that the user did not name, as they are shown. */
    List<String> neededBy(Unit unit) {
        List<String> needed = new ArrayList<>();
        Path place = place(unit.file().path());
        boolean absolute = Path.of(unit.file().path()).isAbsolute();
        ModelRoot.of(unit, place)
                .filter(root -> searched.stream().noneMatch(real(root)::startsWith))
                .map(root -> roots.neededBy(unit, place, root))
                .orElse(Set.of())
                .stream()
                .filter(path -> !isNamed(path))
                .forEach(path -> needed.add(names.shown(path, absolute)));
        needed.addAll(library.pathsFor(unit, places));
        return needed;
    }

    /** Asking the file system for all real names takes longer than most checks; links are rare. */
    private boolean isNamed(Path path) {
        if (places.contains(path.toAbsolutePath().normalize())) {
            return true;
        }
        if (named.isEmpty()) {
            places.forEach(place -> named.add(real(place)));
        }
        return named.contains(real(path));
    }

    /** The folders that were looked into so far, with digests of what else is in there. */
    Map<String, String> folders() {
        Map<String, String> digests = new HashMap<>();
        roots.folders().forEach(folder -> digests.put(folder.toString(), digest(folder)));
        return digests;
    }

    /** Whether nothing came to folders or went but for files that the user names. */
    boolean areAsBefore(Map<String, String> folders) {
        return folders.entrySet().stream()
                .allMatch(each -> digest(Path.of(each.getKey())).equals(each.getValue()));
    }

    private String digest(Path folder) {
        Set<String> others = new TreeSet<>(roots.referable(folder));
        others.removeIf(name -> places.contains(folder.resolve(name)));
        return Sha256.hex(String.join("/", others));
    }

    private Path place(String shown) {
        return names.resolve(shown).toAbsolutePath().normalize();
    }

    private Path real(Path path) {
        return real.computeIfAbsent(path, PathNames::real);
    }
}

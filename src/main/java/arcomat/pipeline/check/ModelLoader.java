package arcomat.pipeline.check;

import arcomat.guest.host.Guests;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.file.FileFinder;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.guest.ForeignBehaviours;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.Parsed;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;

/**
 * From paths to trees: finds files, reads them, parses them, and adds what they refer to, from
 * their model roots and from the library of the tool.
 */
public final class ModelLoader {
    /** Below this many characters one thread is done before a second one has started. */
    private static final int WORTH_A_SECOND_THREAD = 500_000;

    private final PathNames names;
    private final Progress progress;
    private final Guests guests;
    private final List<SourceFile> sources = new ArrayList<>();
    private final List<Unit> units = new ArrayList<>();
    private final List<Recovered> recovered = new ArrayList<>();
    private final Set<String> broken = new HashSet<>();
    private final List<Diagnostic> findings = new ArrayList<>();
    private final Map<String, Path> places = new HashMap<>();
    private final Set<Path> known = new HashSet<>();

    private ModelLoader(Session session) {
        this.names = session.names();
        this.progress = session.progress();
        this.guests = session.guests();
    }

    static LoadedModels load(List<String> paths, Session session) {
        return new ModelLoader(session).load(paths, session.libraries());
    }

    private LoadedModels load(List<String> paths, List<String> libraries) {
        FoundModels found = FoundModels.find(paths, libraries, guests.endings(), names);
        findings.addAll(found.findings());
        List<Unit> fresh = parse(read(found.all()));
        Set<Path> folders = searchedFolders(paths, names);
        folders.addAll(searchedFolders(libraries, names));
        ModelRoot roots = new ModelRoot(names.fence());
        Set<String> ofLibraries = Set.copyOf(found.pathsOfLibraries());
        Set<String> needed = new HashSet<>(ofLibraries);
        while (!fresh.isEmpty()) {
            List<SourceFile> more = read(needed(fresh, roots, folders));
            more.forEach(file -> needed.add(file.path()));
            fresh = parse(more);
        }
        Library library = new Library();
        fresh = new ArrayList<>(units);
        recovered.stream().map(Recovered::unit).forEach(fresh::add);
        while (!fresh.isEmpty()) {
            List<SourceFile> more = library.neededBy(fresh, places.values());
            more.forEach(file -> needed.add(file.path()));
            fresh = parse(more);
        }
        return new LoadedModels(
                found.paths(), sources, units, recovered, broken, findings, needed, ofLibraries);
    }

    /** Those of the paths that are folders. */
    public static Set<Path> searchedFolders(List<String> paths, PathNames names) {
        Set<Path> folders = new HashSet<>();
        for (String written : paths) {
            Path path = names.resolve(written);
            if (Files.isDirectory(path)) {
                folders.add(PathNames.real(path));
            }
        }
        return folders;
    }

    private List<SourceFile> read(List<FileFinder.Found> found) {
        progress.step("reading", found.size(), "file");
        List<SourceFile> read = new ArrayList<>();
        for (FileFinder.Found file : found) {
            progress.goOn();
            known.add(PathNames.real(file.path()));
            places.put(file.shown(), file.path());
            FileReader.Read result = FileReader.read(file.path(), file.shown());
            result.file().ifPresent(read::add);
            result.finding()
                    .ifPresent(
                            finding -> {
                                findings.add(finding);
                                broken.add(file.shown());
                            });
        }
        return read;
    }

    /** Returns the trees, those with gaps included. */
    private List<Unit> parse(List<SourceFile> fresh) {
        sources.addAll(fresh);
        List<Parsed> parsed = parse(fresh, guests, progress);
        List<Unit> parsedUnits = new ArrayList<>();
        for (int i = 0; i < parsed.size(); i++) {
            Parsed each = parsed.get(i);
            findings.addAll(each.findings());
            each.unit().ifPresent(units::add);
            each.recovered().ifPresent(recovered::add);
            each.readable().ifPresent(parsedUnits::add);
            if (each.unit().isEmpty()) {
                broken.add(fresh.get(i).path());
            }
        }
        return parsedUnits;
    }

    /** Large amounts of text by several threads. */
    public static List<Parsed> parse(List<SourceFile> files, Guests guests, Progress progress) {
        progress.step("parsing", files.size(), "file");
        long size = files.stream().mapToLong(file -> file.text().length()).sum();
        Stream<SourceFile> stream =
                size > WORTH_A_SECOND_THREAD ? files.parallelStream() : files.stream();
        return stream.map(
                        file -> {
                            progress.goOn();
                            return ForeignBehaviours.parse(file, guests);
                        })
                .toList();
    }

    /** Files that units refer to, where their model root was not searched anyway. */
    private List<FileFinder.Found> needed(List<Unit> fresh, ModelRoot roots, Set<Path> folders) {
        List<FileFinder.Found> needed = new ArrayList<>();
        for (Unit unit : fresh) {
            Path place = Objects.requireNonNull(places.get(unit.file().path()));
            boolean absolute = Path.of(unit.file().path()).isAbsolute();
            ModelRoot.of(unit, place)
                    .filter(root -> folders.stream().noneMatch(PathNames.real(root)::startsWith))
                    .map(root -> roots.neededBy(unit, place, root))
                    .orElse(Set.of())
                    .forEach(
                            path -> {
                                if (names.fence().permits(path)
                                        && known.add(PathNames.real(path))) {
                                    needed.add(
                                            new FileFinder.Found(
                                                    path, names.shown(path, absolute)));
                                }
                            });
        }
        return needed;
    }
}

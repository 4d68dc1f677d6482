package arcomat.editor.desk;

import arcomat.guest.host.Guests;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.check.ModelLoader;
import arcomat.pipeline.check.ModelRoot;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.recheck.FirstLook;
import arcomat.pipeline.recheck.LibraryModels;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.tree.Unit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Models by the model root in which each lies. Those of different roots do not see each other,
 * since robots of several people may lie in one folder and have the same names.
 */
final class Roots {
    private static final Pattern PACKAGE =
            Pattern.compile("^\\s*package\\s+([\\w.]+)\\s*;", Pattern.MULTILINE);

    /** Where the Gradle plugin looks for models and for tests. */
    private static final List<Path> SOURCES =
            List.of(Path.of("src", "main", "arc"), Path.of("src", "test", "arc"));

    /** Files; what is done before somebody types is not done again, and two threads have enough. */
    private static final int AT_ONCE = 250;

    private final Guests guests;
    private final Map<Path, OpenModels> roots = new TreeMap<>();
    private LibraryModels libraries = LibraryModels.NONE;

    /** The root of each file. */
    private final Map<Path, Path> homes = new HashMap<>();

    /** What becomes of one root. */
    private record Change(
            List<SourceFile> written, List<Diagnostic> unreadable, Set<String> removed) {}

    Roots(Guests guests) {
        this.guests = guests;
    }

    Collection<OpenModels> all() {
        return roots.values();
    }

    /** All files, but for the library's. */
    Set<Path> files() {
        return Set.copyOf(homes.keySet());
    }

    Optional<OpenModels> of(Path file) {
        return Optional.ofNullable(homes.get(file)).map(roots::get);
    }

    /** The path of a file among the models of its root. */
    static String path(OpenModels models, Path file) {
        return new PathNames(models.root()).shown(file, false);
    }

    /** Checks each root that has changed; whoever is stopped has kept what was done before. */
    void check(Runnable goOn) {
        roots.replaceAll((root, models) -> models.check(goOn));
    }

    /** The same of some files only. */
    void check(Set<Path> files, Runnable goOn) {
        Map<Path, Set<String>> wanted = new HashMap<>();
        for (Path file : files) {
            of(file).ifPresent(
                            models ->
                                    wanted.computeIfAbsent(models.root(), any -> new HashSet<>())
                                            .add(path(models, file)));
        }
        roots.replaceAll(
                (root, models) ->
                        models.check(wanted.getOrDefault(root, Set.of())::contains, goOn));
    }

    /** Checks some of the files that are due in a root, and says whether there were any. */
    boolean checkSome(Runnable goOn) {
        for (Map.Entry<Path, OpenModels> each : roots.entrySet()) {
            Set<String> some =
                    each.getValue().due().stream().limit(AT_ONCE).collect(Collectors.toSet());
            if (!some.isEmpty()) {
                each.setValue(each.getValue().check(some::contains, goOn));
                return true;
            }
        }
        return false;
    }

    /** See {@link FirstLook}; nothing where files around have to say to which root one belongs. */
    Optional<FirstLook> firstLook(Path file, String text) {
        String packageName = packageName(text);
        if (packageName.isEmpty()) {
            return Optional.empty();
        }
        Path home = home(file, packageName);
        return FirstLook.at(home, new SourceFile(path(home, file), text), guests, libraries);
    }

    /**
     * Takes over what files contain now.
     *
     * @param files what came of reading them, by absolute path
     */
    void take(Map<Path, FileReader.Read> files) {
        Map<Path, Change> changes = new TreeMap<>();
        inOrder(files).forEach(each -> take(each.getKey(), each.getValue(), changes));
        apply(changes);
    }

    /** Files that name their package come first: they say where the roots are. */
    static List<Map.Entry<Path, FileReader.Read>> inOrder(Map<Path, FileReader.Read> files) {
        return files.entrySet().stream()
                .sorted(Comparator.comparing(each -> packageName(each.getValue()).isEmpty()))
                .toList();
    }

    private void take(Path file, FileReader.Read read, Map<Path, Change> changes) {
        Path last = homes.get(file);
        Path home = home(file, read, Optional.ofNullable(last));
        homes.put(file, home);
        if (last != null && !last.equals(home)) {
            change(last, changes).removed().add(path(last, file));
        }
        Change change = change(home, changes);
        roots.computeIfAbsent(
                home, root -> OpenModels.in(root, false, guests).referringTo(libraries));
        String path = path(home, file);
        read.file().ifPresent(text -> change.written().add(new SourceFile(path, text.text())));
        read.finding().ifPresent(finding -> change.unreadable().add(at(path, finding)));
    }

    private static Diagnostic at(String path, Diagnostic finding) {
        Span span = finding.span();
        SourceFile file = new SourceFile(path, span.file().text());
        return Diagnostic.error(
                finding.code(), file.span(span.start(), span.end()), finding.message());
    }

    /** From now on models may refer to these of others. */
    void referTo(LibraryModels others) {
        libraries = others;
        roots.replaceAll((root, models) -> models.referringTo(others));
    }

    LibraryModels libraries() {
        return libraries;
    }

    void remove(Collection<Path> files) {
        Map<Path, Change> changes = new TreeMap<>();
        for (Path file : files) {
            Path home = homes.remove(file);
            if (home != null) {
                change(home, changes).removed().add(path(home, file));
            }
        }
        apply(changes);
    }

    private void apply(Map<Path, Change> changes) {
        changes.forEach(
                (root, change) -> {
                    var edit =
                            new OpenModels.Edit(
                                    change.written(), change.unreadable(), change.removed());
                    roots.computeIfPresent(root, (any, models) -> models.with(edit));
                });
    }

    private static Change change(Path root, Map<Path, Change> changes) {
        return changes.computeIfAbsent(
                root, any -> new Change(new ArrayList<>(), new ArrayList<>(), new HashSet<>()));
    }

    private static String path(Path root, Path file) {
        return new PathNames(root).shown(file, false);
    }

    /** Of a text that need not parse. */
    private static String packageName(FileReader.Read read) {
        return packageName(read.file().map(SourceFile::text).orElse(""));
    }

    private static String packageName(String text) {
        Matcher matcher = PACKAGE.matcher(text);
        return matcher.find() ? matcher.group(1) : "";
    }

    /** Whoever names no package, or another one than the folder, belongs to those around. */
    private Path home(Path file, String packageName) {
        Path folder = Objects.requireNonNull(file.getParent());
        Optional<Path> said =
                packageName.isEmpty() ? Optional.empty() : ModelRoot.of(packageName, file);
        return together(said.or(() -> around(folder)).orElse(folder));
    }

    /**
     * Where a guest reads the file, the package may be said in what it stands for, or nowhere: then
     * it stays where it was.
     */
    private Path home(Path file, FileReader.Read read, Optional<Path> last) {
        String written = packageName(read);
        if (!written.isEmpty() || guests.reader(file.toString()).isEmpty()) {
            return home(file, written);
        }
        Optional<String> meant =
                read.file().stream()
                        .flatMap(
                                text ->
                                        ModelLoader.parse(List.of(text), guests, Progress.NONE)
                                                .stream())
                        .flatMap(parsed -> parsed.unit().stream())
                        .map(Unit::packageText)
                        .findFirst();
        return meant.isEmpty() && last.isPresent() ? last.get() : home(file, meant.orElse(""));
    }

    /** Builds keep tests apart from what they are about: both belong to the folder above. */
    private static Path together(Path root) {
        return SOURCES.stream()
                .filter(root::endsWith)
                .findFirst()
                .map(sources -> root.resolve("../..").normalize())
                .orElse(root);
    }

    /** The deepest known root that holds a folder. */
    private Optional<Path> around(Path folder) {
        return roots.keySet().stream()
                .filter(folder::startsWith)
                .max(Comparator.comparing(Path::getNameCount));
    }
}

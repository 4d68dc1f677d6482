package arcomat.pipeline.recheck;

import arcomat.check.Checks;
import arcomat.check.Review;
import arcomat.check.law.Profile;
import arcomat.guest.host.Guests;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.Library;
import arcomat.pipeline.check.ModelLoader;
import arcomat.pipeline.recheck.CheckState.File;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.symbols.names.Lazy;
import arcomat.syntax.Parsed;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * The files of a model root as they are now, those of libraries and of the tool's own that they
 * need included. A value.
 */
final class OpenFiles {
    /** As files are found in folders, those of libraries next, the tool's last. */
    private static final Comparator<String> ORDER =
            Comparator.comparing(OpenFiles::isOfOthers)
                    .thenComparing(Library::isShown)
                    .thenComparing(path -> path.split("/"), Arrays::compare);

    private final Path root;
    private final Guests guests;
    private final LibraryModels libraries;
    private final SortedMap<String, OpenFile> files;
    private final OpenModels.Edition edition = new OpenModels.Edition();
    private final Lazy<Workspace> workspace = new Lazy<>(this::around);
    private final Lazy<Workspace> whole = new Lazy<>(this::withoutBroken);

    /**
     * A file as it is now.
     *
     * @param remembered what a check has to know of it; its findings are those of the last check
     * @param source empty where it cannot be read
     */
    record OpenFile(File remembered, Optional<SourceFile> source, Parsed parsed) {}

    private OpenFiles(
            Path root, Guests guests, LibraryModels libraries, SortedMap<String, OpenFile> files) {
        this.root = root;
        this.guests = guests;
        this.libraries = libraries;
        this.files = files;
    }

    /** None, in a folder. */
    static OpenFiles in(Path root, Guests guests) {
        return new OpenFiles(root, guests, LibraryModels.NONE, new TreeMap<>(ORDER));
    }

    /** The same, which may refer to other models of others from now on. */
    OpenFiles referringTo(LibraryModels others) {
        return new OpenFiles(root, guests, others, files).with(OpenModels.Edit.of(List.of()));
    }

    LibraryModels libraries() {
        return libraries;
    }

    /** Paths of a root's files start there, and those of the tool's library in it. */
    private static boolean isOfOthers(String path) {
        return Library.isShown(path) || Path.of(path).isAbsolute();
    }

    Guests guests() {
        return guests;
    }

    /** Reads the new texts. */
    OpenFiles with(OpenModels.Edit edit) {
        SortedMap<String, OpenFile> after = new TreeMap<>(files);
        after.values().removeIf(file -> !file.remembered().named());
        edit.removed().forEach(after::remove);
        edit.unreadable().forEach(finding -> after.put(path(finding), unreadable(finding)));
        StateOfFiles states = states(after.keySet(), edit);
        List<Parsed> parsed = ModelLoader.parse(edit.written(), guests, Progress.NONE);
        for (int i = 0; i < parsed.size(); i++) {
            SourceFile source = edit.written().get(i);
            after.put(source.path(), open(states, source, parsed.get(i), true));
        }
        addLibraries(after, states);
        if (edit.paths().anyMatch(path -> Library.mayHide(path) && cameOrWent(path, after))) {
            after.replaceAll(
                    (path, file) ->
                            file.source().map(source -> open(states, source, file)).orElse(file));
        }
        addLibrary(after, states);
        return new OpenFiles(root, guests, libraries, after);
    }

    private boolean cameOrWent(String path, Map<String, OpenFile> after) {
        return files.containsKey(path) != after.containsKey(path);
    }

    private StateOfFiles states(Set<String> kept, OpenModels.Edit edit) {
        Set<String> named = new HashSet<>(kept);
        edit.written().forEach(file -> named.add(file.path()));
        named.addAll(libraries.files().keySet());
        PathNames names = new PathNames(root);
        Set<Path> searched = new HashSet<>(libraries.folders());
        searched.add(PathNames.real(root));
        return new StateOfFiles(new FilesAround(names, searched, named));
    }

    static String path(Diagnostic finding) {
        return finding.span().file().path();
    }

    private static OpenFile unreadable(Diagnostic finding) {
        return new OpenFile(
                StateOfFiles.unreadable(path(finding), true),
                Optional.empty(),
                new Parsed(Optional.empty(), Optional.empty(), List.of(finding)));
    }

    private static OpenFile open(
            StateOfFiles states, SourceFile source, Parsed parsed, boolean named) {
        return new OpenFile(states.of(source, parsed, named), Optional.of(source), parsed);
    }

    private static OpenFile open(StateOfFiles states, SourceFile source, OpenFile file) {
        return open(states, source, file.parsed(), file.remembered().named());
    }

    /** What lies in this root as well is its own. */
    private void addLibraries(Map<String, OpenFile> after, StateOfFiles states) {
        PathNames names = new PathNames(root);
        libraries
                .files()
                .forEach(
                        (path, file) -> {
                            if (!after.containsKey(names.shown(Path.of(path), false))) {
                                after.put(path, ofLibrary(path, file, states));
                            }
                        });
    }

    private OpenFile ofLibrary(String path, LibraryModels.LibraryFile file, StateOfFiles states) {
        OpenFile known = files.get(path);
        return known != null && known.parsed() == file.parsed()
                ? known
                : file.source()
                        .map(source -> open(states, source, file.parsed(), false))
                        .orElseGet(
                                () ->
                                        new OpenFile(
                                                StateOfFiles.unreadable(path, false),
                                                Optional.empty(),
                                                file.parsed()));
    }

    /** The tool's models that the others need, over any number of steps. */
    private void addLibrary(Map<String, OpenFile> after, StateOfFiles states) {
        Deque<String> open = new ArrayDeque<>();
        after.values().forEach(file -> open.addAll(file.remembered().needs()));
        while (!open.isEmpty()) {
            String path = open.remove();
            if (!after.containsKey(path)) {
                OpenFile file = files.get(path);
                if (file == null || file.remembered().named()) {
                    SourceFile source = Library.file(path);
                    Parsed parsed =
                            ModelLoader.parse(List.of(source), guests, Progress.NONE).get(0);
                    file = open(states, source, parsed, false);
                }
                after.put(path, file);
                open.addAll(file.remembered().needs());
            }
        }
    }

    Path root() {
        return root;
    }

    /** Another one after each edit. */
    OpenModels.Edition edition() {
        return edition;
    }

    /** All of them, in order. */
    Map<String, OpenFile> all() {
        return Collections.unmodifiableMap(files);
    }

    Optional<OpenFile> file(String path) {
        return Optional.ofNullable(files.get(path));
    }

    /** What names mean, also in what could be read of files with syntax errors. */
    Workspace workspace() {
        return workspace.get();
    }

    private Workspace around() {
        return OpenModels.Draft.around(parsed(), HouseLanguages.and(guests.laws().reader()));
    }

    private Map<String, Parsed> parsed() {
        Map<String, Parsed> parsed = new LinkedHashMap<>();
        files.forEach((path, file) -> parsed.put(path, file.parsed()));
        return parsed;
    }

    /** What names would mean if a file had another text. */
    OpenModels.Draft draft(SourceFile text) {
        Parsed written = ModelLoader.parse(List.of(text), guests, Progress.NONE).get(0);
        return OpenModels.Draft.of(
                parsed(), text.path(), written, HouseLanguages.and(guests.laws().reader()));
    }

    /**
     * The findings about some files.
     *
     * @param wanted their paths
     * @param goOn asked now and then; it may throw what ends the work
     */
    Review review(Set<String> wanted, Profile profile, Runnable goOn) {
        return CheckedModels.review(
                        guests.laws(),
                        whole.get(),
                        profile,
                        unit -> wanted.contains(unit.file().path()),
                        libraries.files().keySet(),
                        goOn)
                .and(
                        Checks.reviewRecovered(
                                guests.laws(),
                                HouseLanguages.and(guests.laws().reader()),
                                recovered(wanted),
                                units(),
                                broken(),
                                List.of(),
                                profile));
    }

    /** What names mean to a check, which looks at files with syntax errors by themselves. */
    private Workspace withoutBroken() {
        return broken().isEmpty()
                ? workspace()
                : Workspace.of(
                        units(), broken(), List.of(), HouseLanguages.and(guests.laws().reader()));
    }

    /** Of the files that parse. */
    private List<Unit> units() {
        return files.values().stream().flatMap(file -> file.parsed().unit().stream()).toList();
    }

    private List<Recovered> recovered(Set<String> wanted) {
        return files.entrySet().stream()
                .filter(each -> wanted.contains(each.getKey()))
                .flatMap(each -> each.getValue().parsed().recovered().stream())
                .toList();
    }

    /** Paths of those that do not. */
    private Set<String> broken() {
        Set<String> broken = new HashSet<>();
        files.forEach(
                (path, file) -> {
                    if (file.parsed().unit().isEmpty()) {
                        broken.add(path);
                    }
                });
        return broken;
    }
}

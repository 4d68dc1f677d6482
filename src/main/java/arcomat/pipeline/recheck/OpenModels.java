package arcomat.pipeline.recheck;

import arcomat.check.Checks;
import arcomat.check.Review;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.check.CheckFiles;
import arcomat.pipeline.check.Library;
import arcomat.pipeline.check.LoadedModels;
import arcomat.pipeline.check.ModelLoader;
import arcomat.pipeline.recheck.CheckState.File;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.symbols.names.Lazy;
import arcomat.syntax.Parsed;
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
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * All models of one model root, in memory, while somebody edits them. Their texts are given, since
 * what is on the screen need not be on the disk. What is found is what {@link CheckFiles} finds in
 * the root's folder; what an edit cannot touch is not checked again.
 *
 * <p>A value: an edit makes another one, and whoever still looks at the old one is not disturbed.
 */
public final class OpenModels {
    /** As files are found in folders, the library's last. */
    private static final Comparator<String> ORDER =
            Comparator.comparing(Library::isShown)
                    .thenComparing(path -> path.split("/"), Arrays::compare);

    private final Path root;
    private final boolean executable;
    private final SortedMap<String, OpenFile> files;
    private final Map<String, File> checked;
    private final Lazy<Workspace> workspace;
    private final Edition edition;

    /** Tells texts from those before; it keeps nothing of them. */
    public static final class Edition {
        private Edition() {}
    }

    /**
     * A file as it is now.
     *
     * @param remembered what a check has to know of it; its findings are those of the last check
     * @param source empty where it cannot be read
     */
    private record OpenFile(File remembered, Optional<SourceFile> source, Parsed parsed) {}

    /**
     * What has become of files.
     *
     * @param written with their new texts; paths are relative to the root, with forward slashes
     * @param unreadable what is to be said of those that are there and cannot be read
     * @param removed paths of those that are not there any more
     */
    public record Edit(List<SourceFile> written, List<Diagnostic> unreadable, Set<String> removed) {
        public static Edit of(List<SourceFile> written) {
            return new Edit(written, List.of(), Set.of());
        }

        private Stream<String> paths() {
            return Stream.of(
                            written.stream().map(SourceFile::path),
                            unreadable.stream().map(OpenModels::path),
                            removed.stream())
                    .flatMap(each -> each);
        }
    }

    private OpenModels(
            Path root,
            boolean executable,
            SortedMap<String, OpenFile> files,
            Map<String, File> checked,
            Edition edition) {
        this.root = root;
        this.executable = executable;
        this.files = files;
        this.checked = checked;
        this.edition = edition;
        this.workspace = new Lazy<>(this::around);
    }

    /** The same with what a check has found. */
    private OpenModels(OpenModels before, Map<String, File> checked) {
        this.root = before.root;
        this.executable = before.executable;
        this.files = before.files;
        this.checked = checked;
        this.edition = before.edition;
        this.workspace = before.workspace;
    }

    private Workspace around() {
        List<Unit> recovered = recovered(path -> true).map(Recovered::unit).toList();
        return Workspace.around(recovered, units(), broken(), List.of());
    }

    /**
     * A root without files.
     *
     * @param root the folder of the models, absolute
     * @param executable also asks for what a model needs in order to run
     */
    public static OpenModels in(Path root, boolean executable) {
        return new OpenModels(root, executable, new TreeMap<>(ORDER), Map.of(), new Edition());
    }

    /** Reads the new texts; findings about meaning stay those of the last check. */
    public OpenModels with(Edit edit) {
        SortedMap<String, OpenFile> after = new TreeMap<>(files);
        after.values().removeIf(file -> !file.remembered().named());
        edit.removed().forEach(after::remove);
        edit.unreadable().forEach(finding -> after.put(path(finding), unreadable(finding)));
        StateOfFiles states = states(after.keySet(), edit);
        List<Parsed> parsed = ModelLoader.parse(edit.written(), Progress.NONE);
        for (int i = 0; i < parsed.size(); i++) {
            SourceFile source = edit.written().get(i);
            after.put(source.path(), open(states, source, parsed.get(i), true));
        }
        if (edit.paths().anyMatch(path -> Library.mayHide(path) && cameOrWent(path, after))) {
            after.replaceAll(
                    (path, file) ->
                            file.source()
                                    .map(source -> open(states, source, file.parsed(), true))
                                    .orElse(file));
        }
        addLibrary(after, states);
        return new OpenModels(root, executable, after, checked, new Edition());
    }

    private boolean cameOrWent(String path, Map<String, OpenFile> after) {
        return files.containsKey(path) != after.containsKey(path);
    }

    private StateOfFiles states(Set<String> kept, Edit edit) {
        Set<String> named = new HashSet<>(kept);
        edit.written().forEach(file -> named.add(file.path()));
        PathNames names = new PathNames(root);
        return new StateOfFiles(new FilesAround(names, Set.of(PathNames.real(root)), named));
    }

    private static String path(Diagnostic finding) {
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

    /** The library's models that the others need, over any number of steps. */
    private void addLibrary(Map<String, OpenFile> after, StateOfFiles states) {
        Deque<String> open = new ArrayDeque<>();
        after.values().forEach(file -> open.addAll(file.remembered().needs()));
        while (!open.isEmpty()) {
            String path = open.remove();
            if (!after.containsKey(path)) {
                OpenFile file = files.get(path);
                if (file == null || file.remembered().named()) {
                    SourceFile source = Library.file(path);
                    Parsed parsed = ModelLoader.parse(List.of(source), Progress.NONE).get(0);
                    file = open(states, source, parsed, false);
                }
                after.put(path, file);
                open.addAll(file.remembered().needs());
            }
        }
    }

    /**
     * Checks what has changed since the last check, and what that touches.
     *
     * @param goOn asked now and then; it may throw what ends the work
     */
    public OpenModels check(Runnable goOn) {
        Map<String, File> now = new LinkedHashMap<>();
        files.forEach((path, file) -> now.put(path, known(path, file)));
        Set<String> affected = affected(now);
        if (affected.isEmpty()) {
            return new OpenModels(this, now);
        }
        var profile = CheckFiles.profile(executable);
        List<Recovered> recovered = recovered(affected::contains).toList();
        Review review =
                Checks.review(
                                recovered.isEmpty() && broken().isEmpty()
                                        ? workspace.get()
                                        : Workspace.of(units(), broken()),
                                profile,
                                unit -> affected.contains(unit.file().path()),
                                goOn)
                        .and(
                                Checks.reviewRecovered(
                                        recovered, units(), broken(), List.of(), profile));
        StateOfFiles.takeOver(
                review, affected, path -> Objects.requireNonNull(files.get(path)).parsed(), now);
        return new OpenModels(this, now);
    }

    /** The first time everything is, and nobody has to find out why. */
    private Set<String> affected(Map<String, File> now) {
        return checked.isEmpty()
                ? Set.copyOf(now.keySet())
                : new Changes(checked, now).affected(new Dependencies(now.values()));
    }

    /** Of the last check, if the text is still the same; why one cannot be read is said afresh. */
    private File known(String path, OpenFile file) {
        File remembered = file.remembered();
        if (file.source().isEmpty()) {
            return remembered.with(file.parsed().findings(), List.of());
        }
        File last = checked.get(path);
        return last != null
                        && last.hash().equals(remembered.hash())
                        && last.needs().equals(remembered.needs())
                ? last
                : remembered;
    }

    /** The folder of the models. */
    public Path root() {
        return root;
    }

    /** All files, the library's that they need included. */
    public Set<String> paths() {
        return Collections.unmodifiableSet(files.keySet());
    }

    /** A file, or nothing where there is none of that path or it cannot be read. */
    public Optional<SourceFile> source(String path) {
        return Optional.ofNullable(files.get(path)).flatMap(OpenFile::source);
    }

    /** What came of reading the text as it is now. */
    public Optional<Parsed> parsed(String path) {
        return Optional.ofNullable(files.get(path)).map(OpenFile::parsed);
    }

    /** Whether the file came with the tool and is nobody's to change. */
    public boolean isLibrary(String path) {
        OpenFile file = files.get(path);
        return file != null && !file.remembered().named();
    }

    /** What names mean now, also in what could be read of files with syntax errors. */
    public Workspace workspace() {
        return workspace.get();
    }

    /** Stands for all texts as they are: another one after each edit, the same after a check. */
    public Edition edition() {
        return edition;
    }

    /**
     * One file, with all that answers about it may depend on.
     *
     * @param path of a file that is there
     */
    public LoadedModels around(String path) {
        return new AnswerScope(this, path).models();
    }

    /** What a check has to know of all files. */
    Map<String, File> remembered() {
        Map<String, File> remembered = new LinkedHashMap<>();
        files.forEach((path, file) -> remembered.put(path, file.remembered()));
        return remembered;
    }

    /** What the last check found in a file, about the text that it had then. */
    public List<Diagnostic> findings(String path) {
        File file = checked.get(path);
        return file == null ? List.of() : file.findings();
    }

    /** The files that {@link #findings} may be asked about. */
    public Set<String> checkedPaths() {
        return Collections.unmodifiableSet(checked.keySet());
    }

    private List<Unit> units() {
        return files.values().stream().flatMap(file -> file.parsed().unit().stream()).toList();
    }

    private Stream<Recovered> recovered(Predicate<String> wanted) {
        return files.entrySet().stream()
                .filter(each -> wanted.test(each.getKey()))
                .flatMap(each -> each.getValue().parsed().recovered().stream());
    }

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

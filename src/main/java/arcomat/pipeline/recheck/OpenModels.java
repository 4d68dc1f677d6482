package arcomat.pipeline.recheck;

import arcomat.guest.host.Guests;
import arcomat.pipeline.check.CheckFiles;
import arcomat.pipeline.check.LoadedModels;
import arcomat.pipeline.recheck.CheckState.File;
import arcomat.pipeline.recheck.OpenFiles.OpenFile;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.symbols.signatures.BehaviourReader;
import arcomat.syntax.Parsed;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * All models of one model root, in memory, while somebody edits them. Their texts are given, since
 * what is on the screen need not be on the disk. What is found is what {@link CheckFiles} finds in
 * the root's folder; what an edit cannot touch is not checked again.
 *
 * <p>A value: an edit makes another one, and whoever still looks at the old one is not disturbed.
 */
public final class OpenModels implements ReadModels {
    private final boolean executable;
    private final OpenFiles files;
    private final Checked checked;

    /**
     * What is known of the last check.
     *
     * @param files with what was found in them
     * @param due paths of those in which something else may be found now
     * @param dependencies between files of then, or of some check before
     * @param edition of the texts
     */
    private record Checked(
            Map<String, File> files,
            Set<String> due,
            Dependencies dependencies,
            Optional<Edition> edition) {
        static final Checked NOTHING =
                new Checked(Map.of(), Set.of(), Dependencies.NONE, Optional.empty());
    }

    /** Tells texts from those before; it keeps nothing of them. */
    public static final class Edition {
        Edition() {}
    }

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

        Stream<String> paths() {
            return Stream.of(
                            written.stream().map(SourceFile::path),
                            unreadable.stream().map(OpenFiles::path),
                            removed.stream())
                    .flatMap(each -> each);
        }
    }

    private OpenModels(boolean executable, OpenFiles files, Checked checked) {
        this.executable = executable;
        this.files = files;
        this.checked = checked;
    }

    /**
     * A root without files.
     *
     * @param root the folder of the models, absolute
     * @param executable also asks for what a model needs in order to run
     * @param guests who bring laws and behaviour languages
     */
    public static OpenModels in(Path root, boolean executable, Guests guests) {
        return new OpenModels(executable, OpenFiles.in(root, guests), Checked.NOTHING);
    }

    /** The same without guests. */
    public static OpenModels in(Path root, boolean executable) {
        return in(root, executable, Guests.NONE);
    }

    /** Who is asked besides the tool itself. */
    public Guests guests() {
        return files.guests();
    }

    /** The same, which may refer to models of others, of which only errors are told. */
    public OpenModels referringTo(LibraryModels others) {
        return new OpenModels(executable, files.referringTo(others), checked);
    }

    /** Those of others that these may refer to. */
    public LibraryModels libraries() {
        return files.libraries();
    }

    /** Reads the new texts; findings about meaning stay those of the last check. */
    public OpenModels with(Edit edit) {
        return new OpenModels(executable, files.with(edit), checked);
    }

    /**
     * One file with another text, for a question about what somebody is writing.
     *
     * @param unit what could be read of it
     * @param workspace of all files, with this one
     */
    public record Draft(Optional<Unit> unit, Workspace workspace) {

        /**
         * @param files what was read of all files, by their paths
         * @param path of the one with another text
         * @param written what was read of that
         * @param reader of behaviours that are not read yet
         */
        public static Draft of(
                Map<String, Parsed> files, String path, Parsed written, BehaviourReader reader) {
            Map<String, Parsed> now = new LinkedHashMap<>(files);
            now.put(path, written);
            return new Draft(written.readable(), around(now, reader));
        }

        /** What names mean, also in what could be read of files with syntax errors. */
        public static Workspace around(Map<String, Parsed> files, BehaviourReader reader) {
            List<Unit> recovered = new ArrayList<>();
            List<Unit> units = new ArrayList<>();
            Set<String> broken = new HashSet<>();
            files.forEach(
                    (path, parsed) -> {
                        parsed.recovered().map(Recovered::unit).ifPresent(recovered::add);
                        parsed.unit().ifPresentOrElse(units::add, () -> broken.add(path));
                    });
            return Workspace.around(recovered, units, broken, List.of(), reader);
        }
    }

    /**
     * What names would mean if a file had another text. It is less than an edit: nothing is
     * compared with what was checked, and the file needs no more of the library than before.
     */
    public Draft draft(SourceFile text) {
        return files.draft(text);
    }

    /**
     * Checks what has changed since the last check, and what that touches.
     *
     * @param goOn asked now and then; it may throw what ends the work
     */
    public OpenModels check(Runnable goOn) {
        return check(path -> true, goOn);
    }

    /**
     * The same for some files; the others stay {@link #due}.
     *
     * @param wanted by their paths
     */
    public OpenModels check(Predicate<String> wanted, Runnable goOn) {
        Checked before = noticed();
        Set<String> now = before.due().stream().filter(wanted).collect(Collectors.toSet());
        if (now.isEmpty()) {
            return new OpenModels(executable, files, before);
        }
        Map<String, File> found = new LinkedHashMap<>(before.files());
        StateOfFiles.takeOver(
                files.review(now, CheckFiles.profile(executable), goOn),
                now,
                path -> files.file(path).orElseThrow().parsed(),
                found);
        Set<String> later = new HashSet<>(before.due());
        later.removeAll(now);
        return new OpenModels(
                executable,
                files,
                new Checked(found, later, before.dependencies(), before.edition()));
    }

    /** What the last check means for the texts as they are now. */
    private Checked noticed() {
        if (checked.edition().filter(files.edition()::equals).isPresent()) {
            return checked;
        }
        Map<String, File> now = new LinkedHashMap<>();
        files.all().forEach((path, file) -> now.put(path, known(path, file)));
        // All are new, and nobody has to find out why; or nobody knows how far a law looks.
        if (checked.files().isEmpty() || guests().laws().looksAnywhere()) {
            return new Checked(
                    now, now.keySet(), checked.dependencies(), Optional.of(files.edition()));
        }
        Dependencies dependencies = checked.dependencies().with(now.values());
        Set<String> due = new HashSet<>(checked.due());
        due.retainAll(now.keySet());
        due.addAll(new Changes(checked.files(), now).affected(dependencies));
        return new Checked(now, due, dependencies, Optional.of(files.edition()));
    }

    /** Of the last check, if the text is still the same; why one cannot be read is said afresh. */
    private File known(String path, OpenFile file) {
        File remembered = file.remembered();
        if (file.source().isEmpty()) {
            return remembered.with(file.parsed().findings(), List.of());
        }
        File last = checked.files().get(path);
        return last != null
                        && last.hash().equals(remembered.hash())
                        && last.needs().equals(remembered.needs())
                ? last
                : remembered;
    }

    /** The folder of the models. */
    public Path root() {
        return files.root();
    }

    /** All files, those of libraries and the tool's that they need included. */
    @Override
    public Set<String> paths() {
        return files.all().keySet();
    }

    /** A file, or nothing where there is none of that path or it cannot be read. */
    @Override
    public Optional<SourceFile> source(String path) {
        return files.file(path).flatMap(OpenFile::source);
    }

    /** What came of reading the text as it is now. */
    @Override
    public Optional<Parsed> parsed(String path) {
        return files.file(path).map(OpenFile::parsed);
    }

    /** Whether the file came with the tool or is one of others, and is nobody's to change. */
    public boolean isLibrary(String path) {
        return files.file(path).filter(file -> !file.remembered().named()).isPresent();
    }

    /** What names mean now, also in what could be read of files with syntax errors. */
    @Override
    public Workspace workspace() {
        return files.workspace();
    }

    /** Stands for all texts as they are: another one after each edit, the same after a check. */
    public Edition edition() {
        return files.edition();
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
        files.all().forEach((path, file) -> remembered.put(path, file.remembered()));
        return remembered;
    }

    /** Between the texts as they are now. */
    Dependencies dependencies() {
        return checked.dependencies().with(remembered().values());
    }

    /** What the last check found in a file, about the text that it had then. */
    public List<Diagnostic> findings(String path) {
        File file = checked.files().get(path);
        return file == null ? List.of() : file.findings();
    }

    /**
     * Files of which {@link #findings} may not be about these texts, as the last check has seen.
     */
    public Set<String> due() {
        return Collections.unmodifiableSet(checked.due());
    }

    /** The files that {@link #findings} may be asked about. */
    public Set<String> checkedPaths() {
        return Collections.unmodifiableSet(checked.files().keySet());
    }
}

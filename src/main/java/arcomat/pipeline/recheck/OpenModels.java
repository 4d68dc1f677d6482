package arcomat.pipeline.recheck;

import arcomat.check.Checks;
import arcomat.check.LawBook;
import arcomat.check.Review;
import arcomat.pipeline.check.CheckFiles;
import arcomat.pipeline.check.LoadedModels;
import arcomat.pipeline.recheck.CheckState.File;
import arcomat.pipeline.recheck.OpenFiles.OpenFile;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parsed;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * All models of one model root, in memory, while somebody edits them. Their texts are given, since
 * what is on the screen need not be on the disk. What is found is what {@link CheckFiles} finds in
 * the root's folder; what an edit cannot touch is not checked again.
 *
 * <p>A value: an edit makes another one, and whoever still looks at the old one is not disturbed.
 */
public final class OpenModels {
    private final boolean executable;
    private final OpenFiles files;
    private final Map<String, File> checked;

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

    private OpenModels(boolean executable, OpenFiles files, Map<String, File> checked) {
        this.executable = executable;
        this.files = files;
        this.checked = checked;
    }

    /**
     * A root without files.
     *
     * @param root the folder of the models, absolute
     * @param executable also asks for what a model needs in order to run
     */
    public static OpenModels in(Path root, boolean executable) {
        return new OpenModels(executable, OpenFiles.in(root), Map.of());
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
    public record Draft(Optional<Unit> unit, Workspace workspace) {}

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
        Map<String, File> now = new LinkedHashMap<>();
        files.all().forEach((path, file) -> now.put(path, known(path, file)));
        Set<String> affected = affected(now);
        if (affected.isEmpty()) {
            return new OpenModels(executable, files, now);
        }
        var profile = CheckFiles.profile(executable);
        List<Recovered> recovered = files.recovered(affected::contains).toList();
        Review review =
                Checks.review(
                                LawBook.OWN,
                                files.whole(),
                                profile,
                                unit -> affected.contains(unit.file().path()),
                                goOn)
                        .and(
                                Checks.reviewRecovered(
                                        LawBook.OWN,
                                        recovered,
                                        files.units(),
                                        files.broken(),
                                        List.of(),
                                        profile));
        StateOfFiles.takeOver(
                review, affected, path -> files.file(path).orElseThrow().parsed(), now);
        return new OpenModels(executable, files, now);
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
        return files.root();
    }

    /** All files, the library's that they need included. */
    public Set<String> paths() {
        return files.all().keySet();
    }

    /** A file, or nothing where there is none of that path or it cannot be read. */
    public Optional<SourceFile> source(String path) {
        return files.file(path).flatMap(OpenFile::source);
    }

    /** What came of reading the text as it is now. */
    public Optional<Parsed> parsed(String path) {
        return files.file(path).map(OpenFile::parsed);
    }

    /** Whether the file came with the tool and is nobody's to change. */
    public boolean isLibrary(String path) {
        return files.file(path).filter(file -> !file.remembered().named()).isPresent();
    }

    /** What names mean now, also in what could be read of files with syntax errors. */
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

    /** What the last check found in a file, about the text that it had then. */
    public List<Diagnostic> findings(String path) {
        File file = checked.get(path);
        return file == null ? List.of() : file.findings();
    }

    /** The files that {@link #findings} may be asked about. */
    public Set<String> checkedPaths() {
        return Collections.unmodifiableSet(checked.keySet());
    }
}

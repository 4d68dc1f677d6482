package arcomat.pipeline.recheck;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.Library;
import arcomat.pipeline.check.ModelLoader;
import arcomat.pipeline.check.NamedFiles;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.recheck.CheckState.File;
import arcomat.source.Diagnostic;
import arcomat.source.Sha256;
import arcomat.source.SourceFile;
import arcomat.source.Suppressed;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiFunction;

/**
 * Checks what changed since the last check and what that touches; of all other files the findings
 * are known. Where files beyond those that the user named come or go, everything is checked, and so
 * it is where there are guests, of whom nobody knows how far they look.
 *
 * @param tool whatever tells this tool from others that may find something else
 */
public record IncrementalCheck(List<String> paths, Profile profile, String tool, Session session) {

    /**
     * @param state for the next check
     * @param checked those of the named files that were checked
     */
    public record Outcome(CheckResult result, CheckState state, List<String> checked) {}

    /**
     * Checks; whatever cannot be used of the state is checked anew.
     *
     * @param file what the last check left, if any
     */
    public Outcome run(StateFile file) {
        return run(
                new CheckMemory(session.guests()),
                (key, named) -> file.read(key, path -> source(path, named)));
    }

    /** Checks with what is remembered, and remembers what is found. */
    public Outcome run(CheckMemory memory) {
        Outcome outcome = run(memory, (key, named) -> memory.state(key));
        memory.keep(outcome.state());
        return outcome;
    }

    private Outcome run(
            CheckMemory memory, BiFunction<String, NamedFiles, Optional<CheckState>> last) {
        Set<Path> searched = ModelLoader.searchedFolders(paths, names());
        searched.addAll(ModelLoader.searchedFolders(session.libraries(), names()));
        NamedFiles named =
                NamedFiles.read(
                        paths,
                        session.libraries(),
                        session.guests().endings(),
                        names(),
                        session.progress(),
                        memory::read);
        String key = key(searched, named);
        Optional<CheckState> before =
                session.laws().looksAnywhere() ? Optional.empty() : last.apply(key, named);
        FilesAround around = new FilesAround(names(), searched, named.all());
        return before.flatMap(state -> update(state, named, around, memory))
                .orElseGet(() -> full(key, searched));
    }

    /** Where something cannot be read, less is found than where everything can. */
    private String key(Set<Path> searched, NamedFiles named) {
        return Sha256.hex(
                String.join(
                        "\n",
                        tool,
                        session.laws().identity(),
                        profile.name(),
                        new TreeSet<>(searched).toString(),
                        String.join("\n", session.libraries()),
                        named.hasErrors() ? "incomplete" : "complete"));
    }

    /** Findings may be about a file that others need; there are few of them. */
    private SourceFile source(String path, NamedFiles named) {
        if (named.readable().containsKey(path)) {
            return named.source(path);
        }
        Path place = names().resolve(path);
        if (Library.isShown(path) && !Files.exists(place)) {
            return Library.file(path);
        }
        return FileReader.read(place, path).file().orElseGet(() -> new SourceFile(path, ""));
    }

    private Outcome full(String key, Set<Path> searched) {
        CheckedModels models = CheckedModels.check(paths, profile, session);
        List<String> found = new ArrayList<>(models.loaded().named());
        found.addAll(models.loaded().libraries());
        FilesAround around = new FilesAround(names(), searched, found);
        List<File> files = new StateOfFiles(around).of(models);
        CheckState state = new CheckState(key, around.folders(), files);
        return new Outcome(models.result(), state, models.loaded().named());
    }

    private Optional<Outcome> update(
            CheckState before, NamedFiles named, FilesAround around, CheckMemory memory) {
        if (!around.areAsBefore(before.folders())) {
            return Optional.empty();
        }
        Update update = Update.of(before, named, new StateOfFiles(around), session, memory);
        if (update.surroundingsChange()) {
            return Optional.empty();
        }
        List<File> files = update.check(profile);
        Map<String, String> folders = new HashMap<>(before.folders());
        folders.putAll(around.folders());
        CheckState state = new CheckState(before.key(), folders, files);
        return Optional.of(new Outcome(result(files, named), state, update.checkedFiles()));
    }

    private PathNames names() {
        return session.names();
    }

    private static CheckResult result(List<File> files, NamedFiles named) {
        List<Diagnostic> findings = new ArrayList<>(named.findings());
        List<Suppressed> suppressed = new ArrayList<>();
        for (File file : files) {
            findings.addAll(file.findings());
            suppressed.addAll(file.suppressed());
        }
        TreeSet<Diagnostic> ordered = new TreeSet<>(Diagnostic.ORDER);
        ordered.addAll(findings);
        if (named.hasErrors()) {
            ordered.removeIf(Checks::isUnusedSuppression);
        }
        suppressed.sort(Comparator.comparing(Suppressed::finding, Diagnostic.ORDER));
        return new CheckResult(List.copyOf(ordered), suppressed, named.paths());
    }
}

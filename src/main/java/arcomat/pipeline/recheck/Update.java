package arcomat.pipeline.recheck;

import arcomat.check.Checks;
import arcomat.check.Review;
import arcomat.check.law.Profile;
import arcomat.pipeline.Session;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.Library;
import arcomat.pipeline.check.NamedFiles;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.recheck.CheckState.File;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.symbols.names.Outline;
import arcomat.syntax.Parsed;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import org.jspecify.annotations.Nullable;

import java.nio.file.Files;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** From the state of the files at the last check to that of the files now. */
final class Update {
    private final Session session;
    private final CheckMemory memory;
    private final NamedFiles named;
    private final StateOfFiles states;
    private final Map<String, File> before = new LinkedHashMap<>();
    private final Map<String, File> after = new LinkedHashMap<>();
    private final Changes changes = new Changes(before, after);
    private final Map<String, SourceFile> others = new HashMap<>();
    private final Map<String, Parsed> parsed = new HashMap<>();
    private final Set<String> affected = new TreeSet<>();

    @SuppressWarnings("NullAway.Init") // what changed is compared before anything is checked
    private Dependencies dependencies;

    private Update(
            CheckState before,
            NamedFiles named,
            StateOfFiles states,
            Session session,
            CheckMemory memory) {
        before.files().forEach(file -> this.before.put(file.path(), file));
        this.named = named;
        this.states = states;
        this.session = session;
        this.memory = memory;
    }

    static Update of(
            CheckState before,
            NamedFiles named,
            StateOfFiles states,
            Session session,
            CheckMemory memory) {
        Update update = new Update(before, named, states, session, memory);
        update.compare();
        return update;
    }

    /** Parses what changed. */
    private void compare() {
        for (String path : named.paths()) {
            after.put(path, now(path, Optional.ofNullable(named.readable().get(path)), true));
        }
        for (String path : named.ofLibraries()) {
            after.put(path, now(path, Optional.ofNullable(named.readable().get(path)), false));
        }
        for (File file : before.values()) {
            if (!file.named() && !after.containsKey(file.path())) {
                after.put(file.path(), notNamed(file));
            }
        }
        dependencies = Dependencies.of(after.values());
        affected.addAll(changes.affected(dependencies));
    }

    private File notNamed(File file) {
        if (Library.isShown(file.path())) {
            return file;
        }
        Optional<SourceFile> source =
                FileReader.read(session.names().resolve(file.path()), file.path()).file();
        source.ifPresent(read -> others.put(file.path(), read));
        return now(file.path(), source, false);
    }

    private File now(String path, Optional<SourceFile> readable, boolean isNamed) {
        if (readable.isEmpty()) {
            return StateOfFiles.unreadable(path, isNamed);
        }
        SourceFile source = readable.get();
        File known = before.get(path);
        if (known != null && known.named() == isNamed && known.hash().equals(memory.hash(source))) {
            return known;
        }
        Parsed result = memory.parsed(source);
        parsed.put(path, result);
        return states.of(source, result, isNamed);
    }

    /**
     * Whether other files may be read than before, or in another order, besides those that the user
     * names; or whether one of them cannot be read.
     */
    boolean surroundingsChange() {
        return changes.paths()
                .anyMatch(path -> changesSurroundings(before.get(path), after.get(path)));
    }

    /** Whether a path may be that of a file of the library or that of another one. */
    private boolean isAmbiguous(File file) {
        return !file.named()
                && Library.isShown(file.path())
                && Files.exists(session.names().resolve(file.path()));
    }

    private boolean changesSurroundings(@Nullable File old, @Nullable File fresh) {
        if (old == null || fresh == null) {
            File single = Objects.requireNonNull(old == null ? fresh : old);
            return !single.named() || !single.needs().isEmpty() || Library.mayHide(single.path());
        }
        return isAmbiguous(fresh)
                || old.named() != fresh.named()
                || !old.needs().equals(fresh.needs())
                || !fresh.named() && !Library.isShown(fresh.path()) && fresh.hash().isEmpty();
    }

    /** Of the files that the user named. */
    List<String> checkedFiles() {
        return affected.stream()
                .filter(path -> Objects.requireNonNull(after.get(path)).named())
                .toList();
    }

    /** Checks what is affected, and returns the state of all files. */
    List<File> check(Profile profile) {
        if (affected.isEmpty()) {
            return List.copyOf(after.values());
        }
        Set<String> needed = dependencies.neededBy(affected);
        parse(needed);
        List<Unit> units = new ArrayList<>();
        List<Outline> outlines = new ArrayList<>();
        Set<String> broken = new HashSet<>();
        List<Recovered> recovered = new ArrayList<>();
        for (File file : after.values()) {
            if (file.names().isEmpty()) {
                broken.add(file.path());
                Optional.ofNullable(parsed.get(file.path()))
                        .filter(any -> affected.contains(file.path()))
                        .flatMap(Parsed::recovered)
                        .ifPresent(recovered::add);
            } else if (needed.contains(file.path())) {
                units.add(Objects.requireNonNull(parsed.get(file.path())).unit().orElseThrow());
            } else {
                outlines.add(file.names().get());
            }
        }
        session.progress().step("checking", affected.size(), "model");
        Workspace workspace =
                Workspace.of(units, broken, outlines, HouseLanguages.and(session.laws().reader()));
        return merge(
                CheckedModels.review(
                                session.laws(),
                                workspace,
                                profile,
                                unit -> affected.contains(unit.file().path()),
                                Set.copyOf(named.ofLibraries()),
                                session.progress()::goOn)
                        .and(
                                Checks.reviewRecovered(
                                        session.laws(),
                                        HouseLanguages.and(session.laws().reader()),
                                        recovered,
                                        units,
                                        broken,
                                        outlines,
                                        profile)));
    }

    private void parse(Set<String> needed) {
        List<SourceFile> missing = new ArrayList<>();
        for (File file : after.values()) {
            boolean isMissing = needed.contains(file.path()) && !parsed.containsKey(file.path());
            if (isMissing && !file.hash().isEmpty()) {
                missing.add(source(file));
            }
        }
        List<Parsed> results = memory.parsed(missing, session.progress());
        for (int i = 0; i < missing.size(); i++) {
            parsed.put(missing.get(i).path(), results.get(i));
        }
    }

    private SourceFile source(File file) {
        if (file.named() || named.readable().containsKey(file.path())) {
            return named.source(file.path());
        }
        SourceFile other = others.get(file.path());
        return other == null ? Library.file(file.path()) : other;
    }

    private List<File> merge(Review review) {
        StateOfFiles.takeOver(review, affected, parsed::get, after);
        return List.copyOf(after.values());
    }
}

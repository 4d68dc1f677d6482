package arcomat.pipeline.recheck;

import arcomat.pipeline.recheck.CheckState.File;
import arcomat.symbols.names.Outline;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/** The difference between the files of two checks. */
final class Changes {
    private final Map<String, File> before;
    private final Map<String, File> after;

    Changes(Collection<File> before, Collection<File> after) {
        this.before = byPath(before);
        this.after = byPath(after);
    }

    private static Map<String, File> byPath(Collection<File> files) {
        Map<String, File> map = new LinkedHashMap<>();
        files.forEach(file -> map.put(file.path(), file));
        return map;
    }

    /**
     * The files there are now whose findings may be others than before.
     *
     * @param dependencies between these files
     */
    Set<String> affected(Dependencies dependencies) {
        Set<String> changed = changed();
        Set<String> affected = new HashSet<>(dependencies.affectedBy(references(changed)));
        changed.stream().filter(after::containsKey).forEach(affected::add);
        boolean otherNames = !names(before, changed).equals(names(after, changed));
        boolean otherwiseComplete = isComplete(before) != isComplete(after);
        for (File file : after.values()) {
            // Whoever does not know a name looks for a similar one among all there are.
            boolean guesses = !file.findings().isEmpty() || !file.suppressed().isEmpty();
            // Nothing is called needless as long as some file cannot be read.
            boolean suppresses = file.mentions().contains("suppress");
            if (otherNames && guesses || otherwiseComplete && suppresses) {
                affected.add(file.path());
            }
        }
        return affected;
    }

    /** Files that are there once only, or with another text. */
    private Set<String> changed() {
        Set<String> changed = new HashSet<>(before.keySet());
        changed.addAll(after.keySet());
        changed.removeIf(path -> hash(before, path).equals(hash(after, path)));
        return changed;
    }

    private static Optional<String> hash(Map<String, File> files, String path) {
        return Optional.ofNullable(files.get(path)).map(File::hash);
    }

    private List<FileReferences> references(Set<String> changed) {
        List<FileReferences> references = new ArrayList<>();
        for (String path : changed) {
            for (Map<String, File> files : List.of(before, after)) {
                Optional.ofNullable(files.get(path))
                        .map(FileReferences::of)
                        .ifPresent(references::add);
            }
        }
        for (String name : packagesThatCameOrWent()) {
            references.add(
                    new FileReferences(List.of(FileReferences.words(name)), Set.of(), Set.of()));
        }
        return references;
    }

    private Set<String> packagesThatCameOrWent() {
        Set<String> old = packages(before);
        Set<String> fresh = packages(after);
        Set<String> both = new HashSet<>(old);
        both.retainAll(fresh);
        Set<String> changed = new HashSet<>(old);
        changed.addAll(fresh);
        changed.removeAll(both);
        return changed;
    }

    private static Set<String> packages(Map<String, File> files) {
        Set<String> packages = new HashSet<>();
        for (File file : files.values()) {
            String name = file.names().map(Outline::packageName).orElse("");
            while (!name.isEmpty() && packages.add(name)) {
                name = name.substring(0, Math.max(0, name.lastIndexOf('.')));
            }
        }
        return packages;
    }

    /** How often some files define each name. */
    private static Map<Outline, Long> names(Map<String, File> files, Set<String> paths) {
        Map<Outline, Long> names = new HashMap<>();
        paths.stream()
                .map(files::get)
                .filter(Objects::nonNull)
                .flatMap(file -> file.names().stream())
                .forEach(each -> names.merge(each, 1L, Long::sum));
        return names;
    }

    private static boolean isComplete(Map<String, File> files) {
        return files.values().stream().allMatch(file -> file.names().isPresent());
    }
}

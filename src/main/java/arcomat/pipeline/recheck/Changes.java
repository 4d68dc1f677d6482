package arcomat.pipeline.recheck;

import arcomat.pipeline.recheck.CheckState.File;
import arcomat.symbols.names.Outline;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The difference between the files of two checks, by their paths. */
record Changes(Map<String, File> before, Map<String, File> after) {
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

    /** All there are or were. */
    Stream<String> paths() {
        return Stream.concat(before.keySet().stream(), after.keySet().stream()).distinct();
    }

    /** Files that are there once only, or with another text. */
    private Set<String> changed() {
        return paths().filter(path -> !hash(before, path).equals(hash(after, path)))
                .collect(Collectors.toSet());
    }

    private static Optional<String> hash(Map<String, File> files, String path) {
        return Optional.ofNullable(files.get(path)).map(File::hash);
    }

    private List<FileInterface> references(Set<String> changed) {
        List<FileInterface> references = new ArrayList<>();
        for (String path : changed) {
            Stream.of(before, after)
                    .flatMap(files -> Stream.ofNullable(files.get(path)))
                    .map(FileInterface::of)
                    .forEach(references::add);
        }
        for (String name : packagesThatCameOrWent()) {
            references.add(
                    new FileInterface(List.of(FileInterface.words(name)), Set.of(), Set.of()));
        }
        return references;
    }

    private Set<String> packagesThatCameOrWent() {
        Set<String> old = packages(before);
        Set<String> fresh = packages(after);
        return Stream.concat(old.stream(), fresh.stream())
                .filter(name -> !old.contains(name) || !fresh.contains(name))
                .collect(Collectors.toSet());
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
        return paths.stream()
                .flatMap(path -> Stream.ofNullable(files.get(path)))
                .flatMap(file -> file.names().stream())
                .collect(Collectors.groupingBy(each -> each, Collectors.counting()));
    }

    private static boolean isComplete(Map<String, File> files) {
        return files.values().stream().allMatch(file -> file.names().isPresent());
    }
}

package arcomat.pipeline.recheck;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * Which files can see a change of which, judged by the words in their texts: a file refers to
 * another one at most if it contains all words of a name that the other one defines. That is more
 * than the names that are resolved, but it holds for names that appear, vanish, move or hide others
 * just as well.
 */
final class Dependencies {
    private final Map<String, FileInterface> files = new LinkedHashMap<>();
    private final Map<String, List<String>> claimants;

    Dependencies(Collection<CheckState.File> files) {
        files.forEach(file -> this.files.put(file.path(), FileInterface.of(file)));
        this.claimants = claimants();
    }

    /**
     * Files, those that claim the same as one of them, and all that they refer to, over any number
     * of steps.
     */
    Set<String> neededBy(Set<String> paths) {
        Set<String> needed = new HashSet<>(paths);
        for (String path : paths) {
            Objects.requireNonNull(files.get(path))
                    .claims()
                    .forEach(claim -> needed.addAll(Objects.requireNonNull(claimants.get(claim))));
        }
        Deque<String> open = new ArrayDeque<>(needed);
        while (!open.isEmpty() && needed.size() < files.size()) {
            Set<String> mentions = Objects.requireNonNull(files.get(open.remove())).mentions();
            files.forEach(
                    (path, other) -> {
                        if (!needed.contains(path)
                                && other.offers().stream().anyMatch(mentions::containsAll)) {
                            needed.add(path);
                            open.add(path);
                        }
                    });
        }
        return needed;
    }

    /**
     * The files whose findings may be others than before, over any number of steps: those that
     * changed, those that refer to one of these, and those that claim what one of these claims.
     *
     * @param changed references of what changed, before and now
     */
    Set<String> affectedBy(Collection<FileInterface> changed) {
        Set<String> affected = new HashSet<>();
        Deque<FileInterface> open = new ArrayDeque<>(changed);
        while (!open.isEmpty()) {
            FileInterface current = open.remove();
            List<String> fresh = new ArrayList<>();
            for (String claim : current.claims()) {
                claimants.getOrDefault(claim, List.of()).stream()
                        .filter(affected::add)
                        .forEach(fresh::add);
            }
            files.forEach(
                    (path, other) -> {
                        if (!affected.contains(path) && refers(other, current)) {
                            affected.add(path);
                            fresh.add(path);
                        }
                    });
            fresh.forEach(path -> open.add(Objects.requireNonNull(files.get(path))));
        }
        return affected;
    }

    private static boolean refers(FileInterface from, FileInterface to) {
        return to.offers().stream().anyMatch(from.mentions()::containsAll);
    }

    private Map<String, List<String>> claimants() {
        Map<String, List<String>> claimants = new HashMap<>();
        files.forEach(
                (path, file) -> {
                    for (String claim : file.claims()) {
                        claimants.computeIfAbsent(claim, any -> new ArrayList<>(1)).add(path);
                    }
                });
        return claimants;
    }
}

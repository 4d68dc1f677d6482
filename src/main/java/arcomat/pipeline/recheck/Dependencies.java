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
import java.util.function.Function;

/**
 * Which files can see a change of which, judged by the words in their texts: a file refers to
 * another one at most if it contains all words of a name that the other one defines. That is more
 * than the names that are resolved, but it holds for names that appear, vanish, move or hide others
 * just as well.
 */
public final class Dependencies {
    private final Map<String, FileInterface> files = new LinkedHashMap<>();
    private final Set<String> named = new HashSet<>();
    private final Map<String, List<String>> claiming = new HashMap<>();

    /** By the last word of what is offered: whoever refers to it mentions that word, too. */
    private final Map<String, List<String>> offering = new HashMap<>();

    Dependencies(Collection<CheckState.File> files) {
        for (CheckState.File file : files) {
            String path = file.path();
            FileInterface face = FileInterface.of(file);
            this.files.put(path, face);
            face.claims().forEach(claim -> add(claiming, claim, path));
            face.offers().forEach(offer -> add(offering, offer.get(offer.size() - 1), path));
            if (file.named()) {
                named.add(path);
            }
        }
    }

    public static Dependencies of(CheckState state) {
        return new Dependencies(state.files());
    }

    private static void add(Map<String, List<String>> index, String key, String path) {
        index.computeIfAbsent(key, any -> new ArrayList<>(1)).add(path);
    }

    /** The files that the user named. */
    public Set<String> named() {
        return Set.copyOf(named);
    }

    /**
     * Those of the paths that are there, and all that they refer to, over any number of steps; with
     * whoever claims the same as one of them.
     */
    public Set<String> neededBy(Collection<String> paths) {
        return reached(paths, path -> neededBy(file(path)));
    }

    /**
     * Those of the paths that are there, all that they refer to, and all that refer to one of
     * these, over any number of steps: what is said about these files depends on no other ones.
     */
    public Set<String> connectedWith(Collection<String> paths) {
        Map<String, List<String>> connected = new HashMap<>();
        files.forEach(
                (path, file) ->
                        neededBy(file)
                                .forEach(
                                        other -> {
                                            add(connected, path, other);
                                            add(connected, other, path);
                                        }));
        return reached(paths, path -> connected.getOrDefault(path, List.of()));
    }

    /**
     * The files whose findings may be others than before, over any number of steps: those that
     * changed, those that refer to one of these, and those that claim what one of these claims.
     *
     * @param changed references of what changed, before and now
     */
    Set<String> affectedBy(Collection<FileInterface> changed) {
        Set<String> spared = new HashSet<>(files.keySet());
        Deque<FileInterface> open = new ArrayDeque<>(changed);
        while (!open.isEmpty()) {
            FileInterface current = open.remove();
            Set<String> touched = new HashSet<>(claimants(current));
            spared.stream().filter(path -> refers(file(path), current)).forEach(touched::add);
            touched.stream().filter(spared::remove).map(this::file).forEach(open::add);
        }
        Set<String> affected = new HashSet<>(files.keySet());
        affected.removeAll(spared);
        return affected;
    }

    /** Whether a text with these words may refer to one of the files. */
    public boolean isMentioned(Collection<String> paths, Set<String> words) {
        return paths.stream()
                .filter(files::containsKey)
                .flatMap(path -> file(path).offers().stream())
                .anyMatch(words::containsAll);
    }

    private FileInterface file(String path) {
        return Objects.requireNonNull(files.get(path));
    }

    private Set<String> reached(
            Collection<String> paths, Function<String, Collection<String>> next) {
        Set<String> reached = new HashSet<>(paths);
        reached.retainAll(files.keySet());
        Deque<String> open = new ArrayDeque<>(reached);
        while (!open.isEmpty()) {
            next.apply(open.remove()).stream().filter(reached::add).forEach(open::add);
        }
        return reached;
    }

    private List<String> neededBy(FileInterface file) {
        List<String> needed = claimants(file);
        for (String word : file.mentions()) {
            offering.getOrDefault(word, List.of()).stream()
                    .filter(other -> refers(file, file(other)))
                    .forEach(needed::add);
        }
        return needed;
    }

    private List<String> claimants(FileInterface file) {
        List<String> claimants = new ArrayList<>();
        file.claims().forEach(claim -> claimants.addAll(claiming.getOrDefault(claim, List.of())));
        return claimants;
    }

    private static boolean refers(FileInterface from, FileInterface to) {
        return to.offers().stream().anyMatch(from.mentions()::containsAll);
    }
}

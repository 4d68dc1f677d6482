package arcomat.pipeline.recheck;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Which files can see a change of which, judged by the words in their texts: a file refers to
 * another one at most if it contains all words of a name that the other one defines. That is more
 * than the names that are resolved, but it holds for names that appear, vanish, move or hide others
 * just as well.
 */
public final class Dependencies {
    static final Dependencies NONE = new Dependencies(Map.of(), Map.of(), Map.of());

    private final Map<String, Known> files;
    private final Map<String, List<String>> claiming;

    /** By the last word of what is offered: whoever refers to it mentions that word, too. */
    private final Map<String, List<String>> offering;

    /**
     * A file.
     *
     * @param hash of its text, on which all else depends
     * @param named whether the user named it
     */
    private record Known(String hash, boolean named, FileInterface face) {
        boolean isAbout(CheckState.File file) {
            return named == file.named() && hash.equals(file.hash());
        }
    }

    private Dependencies(
            Map<String, Known> files,
            Map<String, List<String>> claiming,
            Map<String, List<String>> offering) {
        this.files = files;
        this.claiming = claiming;
        this.offering = offering;
    }

    static Dependencies of(Collection<CheckState.File> files) {
        return NONE.with(files);
    }

    /**
     * Those of other files. What is known of a file whose text is the same is not found out again.
     *
     * @param now all that there are
     */
    Dependencies with(Collection<CheckState.File> now) {
        Dependencies changed =
                new Dependencies(
                        new HashMap<>(files), new HashMap<>(claiming), new HashMap<>(offering));
        Set<String> gone = new HashSet<>(files.keySet());
        for (CheckState.File file : now) {
            gone.remove(file.path());
            Known before = files.get(file.path());
            if (before == null || !before.isAbout(file)) {
                changed.put(file);
            }
        }
        gone.forEach(changed::remove);
        return changed;
    }

    private void put(CheckState.File file) {
        String path = file.path();
        remove(path);
        FileInterface face = FileInterface.of(file);
        files.put(path, new Known(file.hash(), file.named(), face));
        face.claims().forEach(claim -> add(claiming, claim, path));
        face.offers().forEach(offer -> add(offering, last(offer), path));
    }

    private void remove(String path) {
        Known before = files.remove(path);
        if (before != null) {
            before.face().claims().forEach(claim -> remove(claiming, claim, path));
            before.face().offers().forEach(offer -> remove(offering, last(offer), path));
        }
    }

    private static String last(List<String> offer) {
        return offer.get(offer.size() - 1);
    }

    /** Lists are others': whoever looks at them sees no change. */
    private static void add(Map<String, List<String>> index, String key, String path) {
        index.merge(
                key,
                List.of(path),
                (before, one) -> Stream.concat(before.stream(), one.stream()).toList());
    }

    private static void remove(Map<String, List<String>> index, String key, String path) {
        index.computeIfPresent(
                key,
                (any, before) -> {
                    List<String> left = before.stream().filter(each -> !each.equals(path)).toList();
                    return left.isEmpty() ? null : left;
                });
    }

    public static Dependencies of(CheckState state) {
        return of(state.files());
    }

    /** The files that the user named. */
    public Set<String> named() {
        return files.entrySet().stream()
                .filter(each -> each.getValue().named())
                .map(Map.Entry::getKey)
                .collect(Collectors.toUnmodifiableSet());
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
        Map<String, Set<String>> connected = new HashMap<>();
        for (String path : files.keySet()) {
            for (String other : neededBy(file(path))) {
                connected.computeIfAbsent(path, any -> new HashSet<>()).add(other);
                connected.computeIfAbsent(other, any -> new HashSet<>()).add(path);
            }
        }
        return reached(paths, path -> connected.getOrDefault(path, Set.of()));
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
        return Objects.requireNonNull(files.get(path)).face();
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
            for (String other : offering.getOrDefault(word, List.of())) {
                if (refers(file, file(other))) {
                    needed.add(other);
                }
            }
        }
        return needed;
    }

    private List<String> claimants(FileInterface file) {
        List<String> claimants = new ArrayList<>();
        file.claims().forEach(claim -> claimants.addAll(claiming.getOrDefault(claim, List.of())));
        return claimants;
    }

    /** The last words are those that few files mention; this is asked of all pairs of files. */
    private static boolean refers(FileInterface from, FileInterface to) {
        Set<String> mentions = from.mentions();
        for (List<String> offer : to.offers()) {
            if (mentions.contains(last(offer)) && mentions.containsAll(offer)) {
                return true;
            }
        }
        return false;
    }
}

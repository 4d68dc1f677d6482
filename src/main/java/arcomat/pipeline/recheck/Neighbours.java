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

/**
 * Who refers to whom among the files of a check, judged as {@link Dependencies} does, and found by
 * an index of words.
 */
public final class Neighbours {
    private final Map<String, FileInterface> files = new HashMap<>();
    private final Map<String, List<String>> mentioning = new HashMap<>();
    private final Map<String, List<String>> offering = new HashMap<>();
    private final Map<String, List<String>> claiming = new HashMap<>();
    private final Set<String> named = new HashSet<>();

    private Neighbours(CheckState state) {
        for (CheckState.File file : state.files()) {
            FileInterface face = FileInterface.of(file);
            files.put(file.path(), face);
            face.mentions().forEach(word -> add(mentioning, word, file.path()));
            face.claims().forEach(claim -> add(claiming, claim, file.path()));
            for (List<String> offer : face.offers()) {
                add(offering, last(offer), file.path());
            }
            if (file.named()) {
                named.add(file.path());
            }
        }
    }

    public static Neighbours of(CheckState state) {
        return new Neighbours(state);
    }

    private static void add(Map<String, List<String>> index, String word, String path) {
        index.computeIfAbsent(word, any -> new ArrayList<>(1)).add(path);
    }

    private static String last(List<String> words) {
        return words.get(words.size() - 1);
    }

    /** The files that the user named. */
    public Set<String> named() {
        return Set.copyOf(named);
    }

    /**
     * Those of the paths that are there, and all that they refer to, over any number of steps; with
     * whoever claims to be the same.
     */
    public Set<String> neededBy(Collection<String> paths) {
        return reached(paths, false);
    }

    /**
     * Those of the paths that are there, all that they refer to, and all that refer to one of
     * these, over any number of steps: what is said about these files depends on no other ones.
     */
    public Set<String> connectedWith(Collection<String> paths) {
        return reached(paths, true);
    }

    /** Whether a text with these words may refer to one of the files. */
    public boolean isMentioned(Collection<String> paths, Set<String> words) {
        return paths.stream()
                .map(files::get)
                .filter(Objects::nonNull)
                .flatMap(file -> file.offers().stream())
                .anyMatch(words::containsAll);
    }

    private Set<String> reached(Collection<String> paths, boolean backwards) {
        Set<String> reached = new HashSet<>(paths);
        reached.retainAll(files.keySet());
        Deque<String> open = new ArrayDeque<>(reached);
        while (!open.isEmpty()) {
            String path = open.remove();
            List<String> next = new ArrayList<>(referredBy(path));
            for (String claim : Objects.requireNonNull(files.get(path)).claims()) {
                next.addAll(claiming.getOrDefault(claim, List.of()));
            }
            if (backwards) {
                next.addAll(referringTo(path));
            }
            next.stream().filter(reached::add).forEach(open::add);
        }
        return reached;
    }

    private List<String> referredBy(String path) {
        Set<String> mentions = Objects.requireNonNull(files.get(path)).mentions();
        List<String> referred = new ArrayList<>();
        for (String word : mentions) {
            for (String other : offering.getOrDefault(word, List.of())) {
                boolean offers =
                        Objects.requireNonNull(files.get(other)).offers().stream()
                                .anyMatch(mentions::containsAll);
                if (offers) {
                    referred.add(other);
                }
            }
        }
        return referred;
    }

    private List<String> referringTo(String path) {
        List<String> referring = new ArrayList<>();
        for (List<String> offer : Objects.requireNonNull(files.get(path)).offers()) {
            mentioning.getOrDefault(last(offer), List.of()).stream()
                    .filter(
                            other ->
                                    Objects.requireNonNull(files.get(other))
                                            .mentions()
                                            .containsAll(offer))
                    .forEach(referring::add);
        }
        return referring;
    }
}

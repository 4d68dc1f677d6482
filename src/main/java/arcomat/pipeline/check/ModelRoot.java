package arcomat.pipeline.check;

import arcomat.pipeline.Fence;
import arcomat.source.ComposedForm;
import arcomat.tree.Unit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Finds the files that a file needs and that the user did not name, so that {@code arcomat check
 * p/q/Robot.arc} sees what Robot imports. Package {@code p.q} puts the model root two folders up;
 * there and in the file's own folder every name of the text is looked for as a file. Looking by
 * need, and never through whole folders, keeps a file in the home folder from reading all of it.
 */
public final class ModelRoot {
    /** Nobody refers to a suite of tests. */
    private static final List<String> REFERABLE = List.of(".arc", ".cd", ".ioautomaton", ".maa");

    private static final Pattern DOTTED_NAME =
            Pattern.compile(
                    "[\\p{L}_$][\\p{L}\\p{M}\\p{N}_$]*(?:\\.[\\p{L}_$][\\p{L}\\p{M}\\p{N}_$]*)*(\\.\\*)?");

    private final Fence fence;

    /** What is in folders, by the normal forms of the names. */
    private final Map<Path, Map<String, String>> listings = new HashMap<>();

    /** Looks for files where they may be read. */
    public ModelRoot(Fence fence) {
        this.fence = fence;
    }

    /** The folder above a unit's package; empty where folders and package differ. */
    public static Optional<Path> of(Unit unit, Path file) {
        return of(unit.packageText(), file);
    }

    /**
     * As above.
     *
     * @param packageName of what stands in the file; empty for none
     */
    public static Optional<Path> of(String packageName, Path file) {
        Path folder = folderOf(file);
        if (packageName.isEmpty()) {
            return Optional.of(folder);
        }
        String[] packages = packageName.split("\\.");
        for (int i = packages.length - 1; i >= 0; i--) {
            Path name = folder.getFileName();
            if (name == null || !ComposedForm.of(name.toString()).equals(packages[i])) {
                return Optional.empty();
            }
            folder = Objects.requireNonNull(folder.getParent());
        }
        return Optional.of(folder);
    }

    private static Path folderOf(Path file) {
        return Objects.requireNonNull(file.toAbsolutePath().normalize().getParent());
    }

    /** The files that a unit may refer to, in the order of its text. */
    public Set<Path> neededBy(Unit unit, Path file, Path root) {
        Set<Path> needed = new LinkedHashSet<>();
        Path folder = folderOf(file);
        for (String name : namesIn(unit)) {
            addFilesNamed(name, folder, root, needed);
        }
        return needed;
    }

    /** Every name in the text of a unit, in comments too, in the order of the text. */
    static Set<String> namesIn(Unit unit) {
        Set<String> names = new LinkedHashSet<>();
        Matcher matcher = DOTTED_NAME.matcher(unit.file().text());
        while (matcher.find()) {
            names.add(ComposedForm.of(matcher.group()));
        }
        return names;
    }

    private void addFilesNamed(String dottedName, Path folder, Path root, Set<Path> needed) {
        boolean all = dottedName.endsWith(".*");
        String[] parts = (all ? dottedName.replace(".*", "") : dottedName).split("\\.");
        addIfThere(folder, parts[0], needed);
        Path at = root;
        for (String part : parts) {
            addIfThere(at, part, needed);
            String folderName = listing(at).get(part);
            if (folderName == null) {
                return;
            }
            at = at.resolve(folderName);
        }
        if (all) {
            for (String name : listing(at).values()) {
                if (REFERABLE.stream().anyMatch(name::endsWith)) {
                    needed.add(at.resolve(name));
                }
            }
        }
    }

    private void addIfThere(Path folder, String name, Set<Path> needed) {
        for (String ending : REFERABLE) {
            String file = listing(folder).get(name + ending);
            if (file != null) {
                needed.add(folder.resolve(file));
            }
        }
    }

    /** The folders that were looked into. */
    public Set<Path> folders() {
        return listings.keySet();
    }

    /**
     * The names in a folder that a model could refer to: files with models, and what may be folders
     * of a package.
     */
    public Set<String> referable(Path folder) {
        return listing(folder).values().stream()
                .filter(
                        name ->
                                name.indexOf('.') < 0
                                        || REFERABLE.stream().anyMatch(name::endsWith))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private Map<String, String> listing(Path folder) {
        return listings.computeIfAbsent(folder, this::list);
    }

    private Map<String, String> list(Path folder) {
        if (!fence.permits(folder)) {
            return Map.of();
        }
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.map(p -> p.getFileName().toString())
                    .collect(
                            Collectors.toMap(
                                    ComposedForm::of,
                                    Function.identity(),
                                    (one, other) -> one.compareTo(other) < 0 ? one : other,
                                    TreeMap::new));
        } catch (IOException | UncheckedIOException noFolder) {
            return Map.of();
        }
    }
}

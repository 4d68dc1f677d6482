package arcomat.pipeline.check;

import arcomat.source.SourceFile;
import arcomat.tree.Unit;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * The models that travel with the tool: a model root among its resources, so that any model can
 * refer to them. A file is read where a name needs it, and the resources are not looked at before
 * somebody names one of their packages. A model of the user's wins over the library's of the same
 * name.
 */
public final class Library {
    /** The folder of the models; a finding about one of them shows it. */
    static final String ROOT = "library";

    /** Known without a look at the resources, which takes a short check a noticeable time. */
    static final Set<String> PACKAGES = Set.of("nxt");

    /** Paths by the qualified name of what they define; empty until they are needed. */
    private Map<String, String> files = Map.of();

    private final Set<String> taken = new LinkedHashSet<>();

    /**
     * The library's files that units refer to and that were not handed out before.
     *
     * @param own the user's files, whose names the library leaves to them
     */
    List<SourceFile> neededBy(List<Unit> units, Collection<Path> own) {
        List<Unit> referring = units.stream().filter(Library::refersToPackage).toList();
        if (referring.isEmpty()) {
            return List.of();
        }
        index(own);
        Set<String> needed = new LinkedHashSet<>();
        referring.forEach(unit -> addFilesOf(unit, needed));
        needed.removeAll(taken);
        taken.addAll(needed);
        return needed.stream().map(path -> new SourceFile(ROOT + "/" + path, text(path))).toList();
    }

    /**
     * The paths, as findings show them, of the library's files that a unit refers to, handed out or
     * not.
     *
     * @param own as above
     */
    public List<String> pathsFor(Unit unit, Collection<Path> own) {
        if (!refersToPackage(unit)) {
            return List.of();
        }
        index(own);
        Set<String> needed = new LinkedHashSet<>();
        addFilesOf(unit, needed);
        return needed.stream().map(path -> ROOT + "/" + path).toList();
    }

    /** A file by the path that findings show. */
    public static SourceFile file(String shown) {
        return new SourceFile(shown, text(below(shown)));
    }

    /** All models, by their paths below the model root. */
    static Map<String, String> texts() {
        Map<String, String> texts = new TreeMap<>();
        index().values().forEach(path -> texts.put(path, text(path)));
        return texts;
    }

    /** The path below the model root, of one that findings show. */
    public static String below(String shown) {
        return shown.substring(ROOT.length() + 1);
    }

    /** Whether a path, as findings show it, leads into the library. */
    public static boolean isShown(String path) {
        return path.startsWith(ROOT + "/");
    }

    /** Whether a file of the user's may stand in the place of one of the library's. */
    public static boolean mayHide(String path) {
        return PACKAGES.stream().anyMatch(name -> ("/" + path).contains("/" + name + "/"));
    }

    private void index(Collection<Path> own) {
        if (files.isEmpty()) {
            files = index();
            own.forEach(path -> files.remove(qualifiedName(path)));
        }
    }

    private static boolean refersToPackage(Unit unit) {
        String text = unit.file().text();
        return PACKAGES.contains(unit.packageText())
                || PACKAGES.stream().anyMatch(name -> text.contains(name + "."));
    }

    private void addFilesOf(Unit unit, Set<String> needed) {
        for (String name : ModelRoot.namesIn(unit)) {
            if (name.endsWith(".*")) {
                addPackage(name.substring(0, name.length() - ".*".length()), needed);
            }
            addFirstFile(name, needed);
            if (!unit.packageText().isEmpty()) {
                addFirstFile(unit.packageText() + "." + name, needed);
            }
        }
    }

    private void addPackage(String packageName, Set<String> needed) {
        files.forEach(
                (name, path) -> {
                    if (name.substring(0, name.lastIndexOf('.')).equals(packageName)) {
                        needed.add(path);
                    }
                });
    }

    /** Of {@code nxt.Brick.SensorPort}, the file of {@code nxt.Brick}. */
    private void addFirstFile(String dottedName, Set<String> needed) {
        for (int dot = dottedName.indexOf('.'); dot >= 0; ) {
            dot = dottedName.indexOf('.', dot + 1);
            String path = files.get(dot < 0 ? dottedName : dottedName.substring(0, dot));
            if (path != null) {
                needed.add(path);
                return;
            }
        }
    }

    /** The name of what a file in a folder of one package defines. */
    private static String qualifiedName(Path file) {
        Path folder =
                Objects.requireNonNull(file.toAbsolutePath().normalize().getParent()).getFileName();
        String name = file.getFileName().toString();
        return folder + "." + name.substring(0, name.lastIndexOf('.'));
    }

    /** All models, ordered. */
    private static Map<String, String> index() {
        return text("index.txt")
                .lines()
                .collect(
                        Collectors.toMap(
                                path -> path.substring(0, path.lastIndexOf('.')).replace('/', '.'),
                                path -> path,
                                (first, second) -> first,
                                TreeMap::new));
    }

    /**
     * Code written by hand for a target.
     *
     * @param folder the target's folder under a model root
     * @return files by their path below the folder
     */
    public static Map<String, SourceFile> code(String folder) {
        Map<String, SourceFile> code = new TreeMap<>();
        String prefix = folder + "/";
        text("code.txt")
                .lines()
                .filter(path -> path.startsWith(prefix))
                .forEach(
                        path ->
                                code.put(
                                        path.substring(prefix.length()),
                                        new SourceFile(ROOT + "/" + path, text(path))));
        return code;
    }

    private static String text(String path) {
        String resource = "/" + ROOT + "/" + path;
        try (InputStream stream = Library.class.getResourceAsStream(resource)) {
            return new String(
                    Objects.requireNonNull(stream).readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}

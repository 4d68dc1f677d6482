package arcomat;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.graph.Digraph;
import arcomat.graph.StrongComponents;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Code of every project, the tests too, as a newcomer meets it: folder by folder. */
class FoldersTest {
    /** Once for all cases: it takes seconds. */
    @BeforeAll
    static void readClasses() {
        assertThat(House.rooms()).isNotEmpty();
    }

    /** Of the tool, what projects beside it may name. */
    private static final List<String> DOORS = List.of("arcomat.brick.api", "arcomat.cli");

    /** The rooms that are seen through the door for guests: {@code guests/api} packs them. */
    private static final List<String> API =
            List.of("guest", "check.law", "symbols", "tree", "model", "source", "graph");

    /** What a person takes in at a glance. */
    private static final int FILES = 30;

    /** Folders that show more, and why. */
    private static final Map<String, String> LARGE =
            Map.of(
                    "lejos-runtime/sim/src/main/java/lejos/nxt",
                    "leJOS has these classes there",
                    "verify/src/test/java/arcomat/laws",
                    "each law has a file, beside what tries them");

    private static final Map<Path, List<Path>> CODE = code();

    @Test
    void noFolderShowsMoreFilesThanOneSeesAtAGlance() {
        Map<String, Integer> shown = new TreeMap<>();
        CODE.forEach((folder, files) -> shown.put(folder.toString(), files.size()));
        LARGE.keySet().forEach(each -> assertThat(shown.remove(each)).isGreaterThan(FILES));
        assertThat(shown)
                .allSatisfy((folder, files) -> assertThat(files).isLessThanOrEqualTo(FILES));
    }

    /** Two classes of one name are mistaken for each other in every conversation. */
    @Test
    void noTwoClassesOfTheToolShareASimpleName() {
        Map<String, List<Path>> named = new TreeMap<>();
        CODE.forEach(
                (folder, files) -> {
                    if (isOfTheTool(folder) && folder.toString().contains("src/main/java")) {
                        files.forEach(
                                file ->
                                        named.computeIfAbsent(name(file), name -> new ArrayList<>())
                                                .add(folder));
                    }
                });
        named.values().removeIf(folders -> folders.size() == 1);
        Set<Path> pair =
                Set.of(
                        Path.of("src/main/java/arcomat/tree"),
                        Path.of("src/main/java/arcomat/model"));
        assertThat(named)
                .as(
                        "what was written (tree) and what is meant (model) are called the same,"
                                + " nothing else")
                .allSatisfy((name, folders) -> assertThat(Set.copyOf(folders)).isEqualTo(pair));
    }

    private static final Pattern IMPORT =
            Pattern.compile("^import (?:static )?([a-z][\\w.]*?)\\.[A-Z].*;", Pattern.MULTILINE);

    /**
     * The tool's own packages are asked by {@link ArchitectureTest}; here are the other projects'.
     */
    @Test
    void noTwoPackagesOfAnotherProjectUseEachOther() {
        Map<String, Set<String>> uses = new TreeMap<>();
        CODE.forEach(
                (folder, files) -> {
                    if (!isOfTheTool(folder) && !folder.toString().contains("/test/")) {
                        files.forEach(
                                file ->
                                        uses.computeIfAbsent(
                                                        packageOf(file), name -> new TreeSet<>())
                                                .addAll(imports(file)));
                    }
                });
        List<String> names = List.copyOf(uses.keySet());
        Digraph imports = new Digraph(names.size());
        uses.forEach(
                (from, targets) ->
                        targets.stream()
                                .filter(to -> !to.equals(from) && names.contains(to))
                                .forEach(
                                        to ->
                                                imports.addEdge(
                                                        names.indexOf(from), names.indexOf(to))));
        assertThat(StrongComponents.of(imports).cyclic())
                .extracting(knot -> IntStream.of(knot).mapToObj(names::get).toList())
                .isEmpty();
    }

    /**
     * Programs are linked with the runtime, plugins run inside of builds: none knows the tool's
     * rooms. Engines for clusters are loaded by it; the live page is made of it, and the site reads
     * models with it; Maven brings it to its plugin, which knows the door that is there for other
     * programs.
     */
    @Test
    void projectsBesideTheToolKnowNothingOfIt() {
        Set<String> rooms = House.rooms();
        CODE.forEach(
                (folder, files) -> {
                    if (!isOfTheTool(folder)
                            && Stream.of("benchmarks", "cluster", "docs", "guests", "live", "site")
                                    .noneMatch(folder::startsWith)) {
                        assertThat(files.stream().flatMap(file -> imports(file).stream()))
                                .filteredOn(each -> each.startsWith("arcomat."))
                                .filteredOn(each -> rooms.contains(each.split("\\.")[1]))
                                .isSubsetOf(DOORS);
                    }
                });
    }

    /** Guests see what {@code arcomat-api} holds, and that needs nothing else of the tool. */
    @Test
    void guestsKnowWhatTheirApiHolds() {
        List<Path> theirs =
                CODE.values().stream()
                        .flatMap(List::stream)
                        .filter(
                                file ->
                                        file.startsWith("guests")
                                                || file.startsWith("src/main")
                                                        && isOfApi(packageOf(file)))
                        .toList();
        assertThat(theirs).anyMatch(file -> file.startsWith("guests"));
        assertThat(theirs)
                .allSatisfy(
                        file ->
                                assertThat(imports(file))
                                        .filteredOn(each -> each.startsWith("arcomat."))
                                        .allMatch(FoldersTest::isOfApi));
    }

    private static boolean isOfApi(String name) {
        return !name.startsWith("arcomat.guest.host")
                && API.stream().anyMatch(room -> (name + ".").startsWith("arcomat." + room + "."));
    }

    private static boolean isOfTheTool(Path folder) {
        return folder.startsWith("src") || House.WINGS.contains(folder.getName(0).toString());
    }

    private static String name(Path file) {
        return file.getFileName().toString().replace(".java", "");
    }

    private static String packageOf(Path file) {
        return file.getParent().toString().replaceFirst(".*/java/", "").replace('/', '.');
    }

    private static Set<String> imports(Path file) {
        try {
            Matcher matcher = IMPORT.matcher(Files.readString(file));
            return matcher.results().map(each -> each.group(1)).collect(Collectors.toSet());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Map<Path, List<Path>> code() {
        Map<Path, List<Path>> code = new TreeMap<>();
        try {
            Files.walkFileTree(
                    Path.of(""),
                    new SimpleFileVisitor<>() {
                        @Override
                        public FileVisitResult preVisitDirectory(
                                Path folder, BasicFileAttributes attributes) {
                            String name = folder.getFileName().toString();
                            return name.equals("build")
                                                    && Files.notExists(
                                                            folder.resolve("package-info.java"))
                                            || name.startsWith(".")
                                    ? FileVisitResult.SKIP_SUBTREE
                                    : FileVisitResult.CONTINUE;
                        }

                        @Override
                        public FileVisitResult visitFile(
                                Path file, BasicFileAttributes attributes) {
                            if (file.toString().endsWith(".java")
                                    && !name(file).equals("package-info")
                                    && file.toString().contains("/java/")) {
                                code.computeIfAbsent(file.getParent(), folder -> new ArrayList<>())
                                        .add(file);
                            }
                            return FileVisitResult.CONTINUE;
                        }
                    });
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return code;
    }
}

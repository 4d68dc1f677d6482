package arcomat;

import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.graph.Digraph;
import arcomat.graph.StrongComponents;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.syntax.ArchRuleDefinition;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;

/**
 * The table of allowed imports. Text knows nothing of targets, targets know nothing of text; both
 * know the model. A new room is a new row with a reason in its package-info.
 */
class ArchitectureTest {
    /** Once for all cases: it takes seconds. */
    @BeforeAll
    static void readClasses() {
        assertThat(House.rooms()).isNotEmpty();
    }

    /**
     * @param rooms what it may import besides itself, the ground and the JDK
     * @param libraries package prefixes of outside libraries allowed here
     */
    private record Row(Set<String> rooms, Set<String> libraries) {}

    private static Row row(String rooms, String... libraries) {
        return new Row(rooms.isEmpty() ? Set.of() : Set.of(rooms.split(" ")), Set.of(libraries));
    }

    private static final Map<String, Row> TABLE =
            Map.ofEntries(
                    Map.entry("source", row("")),
                    Map.entry("graph", row("")),
                    Map.entry("tree", row("")),
                    Map.entry("model", row("")),
                    Map.entry("syntax", row("tree", "org.antlr")),
                    Map.entry("symbols", row("tree")),
                    Map.entry("check", row("symbols tree")),
                    Map.entry("guest", row("check tree model")),
                    // What every guest may know, and nothing else.
                    Map.entry("table", row("guest")),
                    Map.entry("translate", row("guest table syntax symbols tree")),
                    Map.entry("lower", row("model symbols tree")),
                    Map.entry("semantics", row("model rt")),
                    Map.entry(
                            "analysis",
                            row("semantics model rt", "com.carrotsearch.hppc", "de.uni_freiburg")),
                    // What can be simulated is known where it is.
                    Map.entry("brick", row("sim", "org.objectweb.asm")),
                    Map.entry("world", row("")),
                    Map.entry("campaign", row("world", "org.hipparchus")),
                    Map.entry("simulate", row("semantics model rt")),
                    Map.entry("diagram", row("model", "org.eclipse.elk", "org.eclipse.emf")),
                    Map.entry("generate", row("semantics model", "freemarker")),
                    Map.entry(
                            "report",
                            row(
                                    "analysis semantics brick simulate generate diagram model sim"
                                            + " world campaign rt",
                                    "com.fasterxml.jackson")),
                    Map.entry(
                            "pipeline",
                            row(
                                    "syntax tree symbols check guest translate lower model"
                                            + " semantics analysis"
                                            + " simulate generate diagram report brick rt sim world"
                                            + " campaign",
                                    "org.eclipse.jdt",
                                    "com.fasterxml.jackson",
                                    "com.github.weisj",
                                    "javax.imageio",
                                    // Tables by columns; of Hadoop only what stands in for it.
                                    "org.apache.parquet",
                                    "org.apache.hadoop")),
                    Map.entry(
                            "editor",
                            row(
                                    "pipeline syntax tree symbols check guest translate report",
                                    "org.eclipse.lsp4j",
                                    "com.google.gson")),
                    // Of the editor's protocol only what agents speak as well: JSON-RPC.
                    Map.entry(
                            "agent",
                            row(
                                    "pipeline report analysis world sim",
                                    "org.eclipse.lsp4j.jsonrpc",
                                    "com.google.gson")),
                    Map.entry("cli", row("pipeline editor agent", "picocli")));

    /** What the pipeline hands out to the command line: data of other rooms. */
    private static final Set<String> HANDED_OUT =
            Set.of(
                    "model",
                    "semantics",
                    "analysis",
                    "simulate",
                    "brick",
                    "sim",
                    "report",
                    "world",
                    "campaign");

    @TestFactory
    List<DynamicTest> roomsImportOnlyWhatTheTableAllows() {
        List<DynamicTest> tests = new ArrayList<>();
        for (String room : House.rooms()) {
            tests.add(DynamicTest.dynamicTest(room, () -> checkRoom(room)));
        }
        return tests;
    }

    private static void checkRoom(String room) {
        Row row = TABLE.get(room);
        assertThat(row).as("room %s has a row in the table", room).isNotNull();
        ArchRuleDefinition.classes()
                .that()
                .resideInAPackage("arcomat." + room + "..")
                .should()
                .onlyDependOnClassesThat(allowed(room, row))
                .check(House.CLASSES);
    }

    private static DescribedPredicate<JavaClass> allowed(String room, Row row) {
        return DescribedPredicate.describe(
                "are allowed in " + room,
                target -> {
                    String name = target.getBaseComponentType().getPackageName();
                    if (name.isEmpty() || name.startsWith("java.")) {
                        return true;
                    }
                    if (name.startsWith("arcomat.")) {
                        String other = House.room(name);
                        return other.equals(room)
                                || House.GROUND.contains(other)
                                || row.rooms().contains(other)
                                || room.equals("cli") && HANDED_OUT.contains(other);
                    }
                    return row.libraries().stream().anyMatch(name::startsWith);
                });
    }

    @Tag("slow")
    @Test
    void thereAreNoCyclesBetweenRooms() {
        slices().matching("arcomat.(*)..").should().beFreeOfCycles().check(House.CLASSES);
    }

    /** Each package can be read without those that use it, also inside of a room. */
    @Tag("slow")
    @Test
    void thereAreNoCyclesBetweenPackages() {
        slices().matching("arcomat.(**)").should().beFreeOfCycles().check(House.CLASSES);
    }

    /** What knows each other has to be read at once: that many can be. */
    private static final int KNOT = 12;

    @Test
    void noKnotOfClassesIsTooLargeToRead() {
        List<String> names =
                House.CLASSES.stream().map(ArchitectureTest::topLevel).distinct().sorted().toList();
        Digraph imports = new Digraph(names.size());
        for (JavaClass each : House.CLASSES) {
            int from = Collections.binarySearch(names, topLevel(each));
            each.getDirectDependenciesFromSelf().stream()
                    .map(use -> topLevel(use.getTargetClass().getBaseComponentType()))
                    .mapToInt(target -> Collections.binarySearch(names, target))
                    .filter(to -> to >= 0 && to != from)
                    .forEach(to -> imports.addEdge(from, to));
        }
        assertThat(StrongComponents.of(imports).cyclic())
                .extracting(knot -> IntStream.of(knot).mapToObj(names::get).toList())
                .filteredOn(knot -> !knot.get(0).startsWith("arcomat.syntax.antlr."))
                .allSatisfy(knot -> assertThat(knot).hasSizeLessThanOrEqualTo(KNOT));
    }

    private static String topLevel(JavaClass type) {
        return type.getName().replaceAll("\\$.*", "");
    }

    /** Only what begins there is the same in every year and in every time zone. */
    @Test
    void entriesOfArchivesBeginInOnePlace() {
        ArchRuleDefinition.noClasses()
                .that()
                .doNotHaveFullyQualifiedName("arcomat.pipeline.file.ArchiveEntry")
                .and()
                .resideOutsideOfPackage("arcomat.brick.api") // a step of the build, with its test
                .should()
                .callConstructor(ZipEntry.class, String.class)
                .check(House.CLASSES);
    }

    @Test
    void everyRoomAndEveryPartOfARoomSaysWhatItIsFor() throws IOException {
        for (String wing : House.WINGS) {
            try (Stream<Path> files = Files.walk(Path.of(wing, "src/main/java"))) {
                Set<Path> folders =
                        files.filter(file -> file.toString().endsWith(".java"))
                                .map(Path::getParent)
                                .collect(Collectors.toSet());
                assertThat(folders)
                        .allSatisfy(each -> assertThat(each.resolve("package-info.java")).exists());
            }
        }
    }
}

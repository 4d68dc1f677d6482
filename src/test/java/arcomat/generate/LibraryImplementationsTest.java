package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.models.ModelFiles;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What is written by hand for the brick fits what is generated for the other targets. */
class LibraryImplementationsTest {
    private static final Path WRITTEN = Path.of("lejos-runtime/nxt/src/main/java");
    private static final Pattern PUBLIC_MEMBER =
            Pattern.compile("(?m)^    public ([^;={]*[^;={ ])");

    private static final Model MODEL =
            Lowering.lower(Scenario.models("src/test/resources/library"));
    private static final Request REQUEST = Request.all(MODEL, Choosing.FIRST);

    /** Generated code of every target sets and reads the same fields and calls the same methods. */
    @TestFactory
    Stream<DynamicTest> everyImplementationHasTheMembersOfTheGeneratedClass() {
        Map<String, String> generated = platformFiles();
        assertThat(generated.keySet().stream().map(LibraryImplementationsTest::general))
                .as("the test uses every component")
                .containsAll(components());
        return generated.entrySet().stream()
                .map(
                        file ->
                                DynamicTest.dynamicTest(
                                        file.getKey(),
                                        () ->
                                                assertThat(members(written(file.getKey())))
                                                        .isEqualTo(members(file.getValue()))));
    }

    /** Of target jvm, by path. */
    private static Map<String, String> platformFiles() {
        Generation generation = Generator.generate(REQUEST, Target.shipped("jvm").orElseThrow());
        assertThat(generation.findings()).isEmpty();
        Map<String, String> files = new TreeMap<>();
        for (GeneratedFile file : generation.files()) {
            if (file.path().matches("nxt/(sensors|actuators)/.*")) {
                files.put(file.path(), file.text());
            }
        }
        return files;
    }

    /** Simple names of the library's components. */
    private static Set<String> components() {
        try (Stream<Path> files = Files.list(ModelFiles.LIBRARY.resolve("nxt"))) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(".arc"))
                    .map(name -> name.replace(".arc", ""))
                    .collect(Collectors.toSet());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The text for a generated class; one text may serve all enums. */
    private static String written(String path) {
        try {
            Path own = WRITTEN.resolve(path);
            if (Files.exists(own)) {
                return Files.readString(own);
            }
            String specific = simpleName(path);
            return Files.readString(own.resolveSibling(general(path) + ".java"))
                    .replaceAll("\\b" + general(path) + "\\b", specific);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String general(String path) {
        return simpleName(path).replaceFirst("Of.*", "");
    }

    private static String simpleName(String path) {
        return path.substring(path.lastIndexOf('/') + 1).replace(".java", "");
    }

    /** Heads of the public fields, constructors and methods. */
    private static Set<String> members(String text) {
        return PUBLIC_MEMBER
                .matcher(text)
                .results()
                .map(found -> found.group(1))
                .collect(Collectors.toCollection(TreeSet::new));
    }
}

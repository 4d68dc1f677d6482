package arcomat.gradle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.time.LocalDateTime;
import java.util.HexFormat;
import java.util.List;
import java.util.jar.JarFile;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;

import javax.xml.parsers.DocumentBuilderFactory;

/** What a repository gets can be used without this build, by the tools that ask for the details. */
@Tag("build")
class PublishedArtifactsTest {
    private static final String VERSION = System.getProperty("version");

    /** What a user of an artifact gets along with it, and nothing that only this build needs. */
    @ParameterizedTest
    @CsvSource({
        "arcomat, antlr4-runtime arcomat-brick-api arcomat-brick-simulation arcomat-runtime"
                + " asm-analysis asm-tree ecj freemarker gson guava hipparchus-core hppc"
                + " jackson-databind jsvg org.eclipse.elk.alg.layered org.eclipse.emf.ecore"
                + " org.eclipse.lsp4j parquet-floor picocli slf4j-nop smtinterpol",
        "arcomat-api, jspecify",
        "arcomat-brick-api, asm",
        "arcomat-brick-simulation, arcomat-brick-api asm asm-analysis asm-tree",
        "arcomat-cluster-hazelcast, arcomat hazelcast",
        "arcomat-cluster-spark, arcomat",
        "arcomat-gradle-plugin, ''",
        "arcomat-maven-plugin, arcomat",
        "arcomat-runtime, ''",
        "arcomat.gradle.plugin, arcomat-gradle-plugin"
    })
    void aPomSaysWhatItIsAndNeeds(String name, String needed) throws Exception {
        Document pom =
                DocumentBuilderFactory.newInstance()
                        .newDocumentBuilder()
                        .parse(file(name, ".pom").toFile());
        Element project = pom.getDocumentElement();
        assertThat(texts(project, "description").get(0)).endsWith(".");
        assertThat(texts(project, "license").get(0))
                .contains("Apache-2.0", "https://www.apache.org/licenses/LICENSE-2.0.txt");
        // Maven Central takes nothing without these.
        for (String each : List.of("name", "url", "scm", "developer")) {
            assertThat(texts(project, each).get(0)).as(each).isNotBlank();
        }

        List<Element> dependencies = elements(project, "dependency").toList();
        assertThat(dependencies)
                .extracting(dependency -> texts(dependency, "artifactId").get(0)) // then exclusions
                .containsExactlyInAnyOrder(needed.isEmpty() ? new String[0] : needed.split(" "));
        assertThat(texts(project, "version"))
                .hasSize(dependencies.size() + 1)
                .allMatch(version -> version.matches("\\d.*"))
                .noneMatch(version -> version.endsWith("-SNAPSHOT"));
    }

    @ParameterizedTest
    @CsvSource({
        "arcomat, arcomat/cli/Main",
        "arcomat-api, arcomat/guest/Guest",
        "arcomat-brick-api, arcomat/brick/api/StubJar",
        "arcomat-brick-simulation, lejos/nxt/Motor",
        "arcomat-cluster-hazelcast, arcomat/cluster/hazelcast/HazelcastProvider",
        "arcomat-cluster-spark, arcomat/cluster/spark/SparkCampaign",
        "arcomat-gradle-plugin, arcomat/gradle/ArcomatPlugin",
        "arcomat-maven-plugin, arcomat/maven/CheckMojo",
        "arcomat-runtime, arcomat/rt/Choice"
    })
    void classesComeWithSourcesAndDocumentation(String name, String example) throws IOException {
        holds(file(name, ".jar"), example + ".class");
        holds(file(name, "-sources.jar"), example + ".java");
        holds(file(name, "-javadoc.jar"), example + ".html");
    }

    /** What the tool consists of, for programs that know which libraries have faults. */
    @Test
    void theToolComesWithItsBillOfMaterials() throws Exception {
        byte[] tool = Files.readAllBytes(file("arcomat", ".jar"));
        byte[] digest = MessageDigest.getInstance("SHA-256").digest(tool);
        assertThat(Files.readString(file("arcomat", "-cyclonedx.json")))
                .contains("\"CycloneDX\"", HexFormat.of().formatHex(digest));
    }

    /** The licence travels with everything, and the time of the build with nothing. */
    private static void holds(Path path, String example) throws IOException {
        try (JarFile jar = new JarFile(path.toFile())) {
            assertThat(jar.getEntry(example)).as("%s in %s", example, path).isNotNull();
            ZipEntry licence = jar.getEntry("META-INF/LICENSE");
            assertThat(licence).as("licence in %s", path).isNotNull();
            assertThat(jar.getInputStream(licence))
                    .hasBinaryContent(Files.readAllBytes(Path.of("../../LICENSE")));
            assertThat(jar.stream())
                    .extracting(ZipEntry::getTimeLocal)
                    .containsOnly(LocalDateTime.of(1980, 2, 1, 0, 0));
        }
    }

    private static Path file(String name, String ending) {
        return Path.of(System.getProperty("repository"), "arcomat", name, VERSION)
                .resolve(name + "-" + VERSION + ending);
    }

    private static List<String> texts(Element parent, String name) {
        return elements(parent, name).map(Element::getTextContent).toList();
    }

    private static Stream<Element> elements(Element parent, String name) {
        NodeList found = parent.getElementsByTagName(name);
        return IntStream.range(0, found.getLength()).mapToObj(found::item).map(Element.class::cast);
    }
}

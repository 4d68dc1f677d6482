package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.InputFormat;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SchemaLocation;
import com.networknt.schema.SpecVersion.VersionFlag;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** The bill of materials says what the distribution holds, in the form that programs read. */
class SbomTest {
    private static final Path SBOM = Path.of("build/sbom");
    private static final String SCHEMAS = "http://cyclonedx.org/schema/";

    private static String text() throws IOException {
        try (Stream<Path> files = Files.list(SBOM)) {
            return Files.readString(files.max(Path::compareTo).orElseThrow());
        }
    }

    private static List<JsonNode> components() throws IOException {
        JsonNode bom = new ObjectMapper().readTree(text());
        List<JsonNode> all = new ArrayList<>();
        bom.get("components").forEach(all::add);
        all.add(bom.get("metadata").get("component"));
        return all;
    }

    @Test
    void isCycloneDx() throws IOException {
        JsonSchemaFactory schemas =
                JsonSchemaFactory.getInstance(
                        VersionFlag.V7,
                        factory ->
                                factory.schemaMappers(
                                        // Nothing is fetched: a library for tests carries them.
                                        found -> found.mapPrefix(SCHEMAS, "classpath:/")));
        var schema = schemas.getSchema(SchemaLocation.of(SCHEMAS + "bom-1.6.schema.json"));
        assertThat(schema.validate(text(), InputFormat.JSON)).isEmpty();
        String wrong = text().replace("EPL-2.0", "as you like it");
        assertThat(schema.validate(wrong, InputFormat.JSON)).isNotEmpty();
    }

    @Test
    void namesEveryJarWithItsContentAndLicence() throws Exception {
        Map<String, String> named = new HashMap<>();
        for (JsonNode component : components()) {
            String name = component.get("name").asText();
            named.put(
                    name + "-" + component.get("version").asText() + ".jar",
                    component.get("hashes").get(0).get("content").asText());
            assertThat(component.get("licenses").get(0).get("license").get("id").asText())
                    .as("licence of %s", name)
                    .isNotBlank();
        }
        Map<String, String> held = new HashMap<>();
        for (Path jar : DistributedJars.all()) {
            held.put(jar.getFileName().toString(), DistributedJars.sha256(jar));
        }
        assertThat(named).isEqualTo(held);
    }

    /** Neither when nor where it was made: the same sources give the same bytes. */
    @Test
    void tellsNothingOfTheBuild() throws IOException {
        assertThat(text())
                .doesNotContain(
                        "timestamp", "serialNumber", Path.of("").toAbsolutePath().toString());
    }
}

package arcomat.report.finding;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.report.finding.Reported.Standing;
import arcomat.report.finding.Reported.Step;
import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

class SarifTest {
    private static final SourceRoot ROOT = new SourceRoot("/home/robot");
    private static final Sarif.Tool TOOL =
            new Sarif.Tool("1.2.3", code -> Optional.of("# " + code + " A title\n\nWhy so.\n"));

    private static Span place(String path) {
        return new SourceFile(path, "component A {\n  port;\n}\n").span(16, 20);
    }

    private static Reported reported(String path, String message) {
        Diagnostic finding = Diagnostic.error("ARC0104", place(path), message);
        return Reported.of(finding, Standing.NEW);
    }

    private static JsonNode run(Reported... results) throws Exception {
        String text = Sarif.render(List.of(results), true, TOOL, ROOT);
        assertThat(SarifSchema.problems(text)).isEmpty();
        return new ObjectMapper().readTree(text).get("runs").get(0);
    }

    private static JsonNode location(String path) throws Exception {
        return run(reported(path, "no"))
                .at("/results/0/locations/0/physicalLocation/artifactLocation");
    }

    @Test
    void theSchemaIsInForce() {
        assertThat(SarifSchema.problems("{\"version\": \"2.1.0\", \"runs\": [{}]}")).isNotEmpty();
        assertThat(SarifSchema.problems("{\"version\": \"2.0.0\", \"runs\": []}")).isNotEmpty();
    }

    @Test
    void pathsCountFromTheRootWhereTheyLieBelow() throws Exception {
        assertThat(location("a/B.arc").get("uri").asText()).isEqualTo("a/B.arc");
        assertThat(location("/home/robot/a/B.arc").get("uri").asText()).isEqualTo("a/B.arc");
        assertThat(location("/home/robot/a/B.arc").get("uriBaseId").asText())
                .isEqualTo("%SRCROOT%");
        assertThat(location("/home/robots/B.arc").get("uri").asText())
                .isEqualTo("file:///home/robots/B.arc");
        assertThat(location("/home/robots/B.arc").has("uriBaseId")).isFalse();
        assertThat(location("C:/x/B.arc").get("uri").asText()).isEqualTo("file:///C%3A/x/B.arc");
        assertThat(location("a:b/50% #ö?.arc").get("uri").asText())
                .isEqualTo("a%3Ab/50%25%20%23%C3%B6%3F.arc");
    }

    @Test
    void bracesOfModelsAreNoPlaceholders() throws Exception {
        assertThat(run(reported("A.arc", "in {0}")).at("/results/0/message/text").asText())
                .isEqualTo("in {{0}}");
    }

    @Test
    void rulesAreThoseThatAreBrokenWithTheirPages() throws Exception {
        Diagnostic other = Diagnostic.warning("ARC0102", place("A.arc"), "b");
        JsonNode run = run(reported("A.arc", "a"), Reported.of(other, Standing.KNOWN));
        JsonNode rules = run.at("/tool/driver/rules");
        assertThat(rules.findValuesAsText("id")).containsExactly("ARC0102", "ARC0104");
        assertThat(rules.at("/1/shortDescription/text").asText()).isEqualTo("A title");
        assertThat(rules.at("/1/fullDescription/text").asText()).isEqualTo("Why so.");
        assertThat(rules.at("/0/defaultConfiguration/level").asText()).isEqualTo("warning");
        assertThat(run.at("/results/0/ruleIndex").asInt()).isEqualTo(1);
        assertThat(run.at("/results/0/baselineState").asText()).isEqualTo("new");
        assertThat(run.at("/results/1/baselineState").asText()).isEqualTo("unchanged");
        assertThat(run.at("/results/1/suppressions/0/kind").asText()).isEqualTo("external");
    }

    @Test
    void allThatAFindingCarriesIsThere() throws Exception {
        Span place = place("A.arc");
        Diagnostic finding =
                Diagnostic.error("ARC0104", place, "wrong")
                        .withRelated(place("B.arc"), "see here")
                        .withFix(Fix.replace("Rename it", place, "gate"));
        Reported meant =
                new Reported(
                        finding, Standing.SUPPRESSED, "so it is", List.of(new Step("go", place)));
        JsonNode result = run(meant).at("/results/0");
        assertThat(result.at("/locations/0/physicalLocation/region/startLine").asInt())
                .isEqualTo(2);
        assertThat(result.at("/locations/0/physicalLocation/region/endColumn").asInt())
                .isEqualTo(7);
        assertThat(result.at("/relatedLocations/0/message/text").asText()).isEqualTo("see here");
        assertThat(result.at("/fixes/0/artifactChanges/0/replacements/0/insertedContent/text"))
                .hasToString("\"gate\"");
        assertThat(result.at("/codeFlows/0/threadFlows/0/locations/0/location/message/text"))
                .hasToString("\"go\"");
        assertThat(result.at("/suppressions/0/justification").asText()).isEqualTo("so it is");
        assertThat(result.has("baselineState")).isFalse();
    }

    @Property(tries = 200)
    void isValidWhateverNamesAndMessagesContain(@ForAll String path, @ForAll String message)
            throws Exception {
        assertThat(run(reported(path, "x" + message)).at("/results").size()).isEqualTo(1);
    }
}

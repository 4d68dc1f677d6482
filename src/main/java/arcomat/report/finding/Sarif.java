package arcomat.report.finding;

import arcomat.report.finding.Reported.Standing;
import arcomat.report.finding.Reported.Step;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;
import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Related;
import arcomat.source.TextEdit;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** Findings in SARIF 2.1.0, the exchange format of OASIS for what tools find in source texts. */
public final class Sarif {
    private static final String SCHEMA =
            "https://docs.oasis-open.org/sarif/sarif/v2.1.0/os/schemas/sarif-schema-2.1.0.json";

    private final JsonGenerator json;
    private final SarifPlaces places;
    private final SarifRules rules;
    private final boolean compared;

    private Sarif(JsonGenerator json, SarifPlaces places, SarifRules rules, boolean compared) {
        this.json = json;
        this.places = places;
        this.rules = rules;
        this.compared = compared;
    }

    /**
     * The tool that found something.
     *
     * @param version of Arcomat, as in {@code 1.2.3}
     * @param pages the page that explains a code, in Markdown
     */
    public record Tool(String version, Function<String, Optional<String>> pages) {}

    /**
     * @param compared whether findings were compared with a baseline
     */
    public static String render(
            List<Reported> results, boolean compared, Tool tool, SourceRoot root) {
        return Json.text(
                json ->
                        new Sarif(
                                        json,
                                        new SarifPlaces(json, root),
                                        SarifRules.of(results, tool.pages()),
                                        compared)
                                .write(results, tool.version()));
    }

    private void write(List<Reported> results, String version) throws IOException {
        json.writeStartObject();
        json.writeStringField("$schema", SCHEMA);
        json.writeStringField("version", "2.1.0");
        json.writeArrayFieldStart("runs");
        json.writeStartObject();
        json.writeObjectFieldStart("tool");
        json.writeObjectFieldStart("driver");
        json.writeStringField("name", "arcomat");
        json.writeStringField("version", version);
        rules.write(json, results);
        json.writeEndObject();
        json.writeEndObject();
        places.writeBases();
        json.writeStringField("columnKind", "utf16CodeUnits");
        json.writeArrayFieldStart("results");
        for (Reported result : results) {
            json.writeStartObject();
            write(result);
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
        json.writeEndArray();
        json.writeEndObject();
    }

    private void write(Reported result) throws IOException {
        Diagnostic finding = result.finding();
        json.writeStringField("ruleId", finding.code());
        json.writeNumberField("ruleIndex", rules.index(finding.code()));
        json.writeStringField("level", SarifRules.level(finding));
        places.writeMessage("message", finding.message());
        json.writeArrayFieldStart("locations");
        places.writeLocation(finding.span(), Optional.empty());
        json.writeEndArray();
        json.writeObjectFieldStart("partialFingerprints");
        json.writeStringField("place/v1", Baseline.fingerprint(finding.span()));
        json.writeEndObject();
        writeRelated(finding.related());
        writeSteps(result.steps());
        if (finding.fix().isPresent()) {
            writeFix(finding.fix().get());
        }
        writeStanding(result);
    }

    private void writeRelated(List<Related> related) throws IOException {
        if (related.isEmpty()) {
            return;
        }
        json.writeArrayFieldStart("relatedLocations");
        for (int i = 0; i < related.size(); i++) {
            json.writeStartObject();
            json.writeNumberField("id", i + 1);
            places.writeLocationFields(related.get(i).span(), Optional.of(related.get(i).note()));
            json.writeEndObject();
        }
        json.writeEndArray();
    }

    /** A run is one thread of one flow. */
    private void writeSteps(List<Step> steps) throws IOException {
        if (steps.isEmpty()) {
            return;
        }
        json.writeArrayFieldStart("codeFlows");
        json.writeStartObject();
        json.writeArrayFieldStart("threadFlows");
        json.writeStartObject();
        json.writeArrayFieldStart("locations");
        for (Step step : steps) {
            json.writeStartObject();
            json.writeObjectFieldStart("location");
            places.writeLocationFields(step.place(), Optional.of(step.text()));
            json.writeEndObject();
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
        json.writeEndArray();
        json.writeEndObject();
        json.writeEndArray();
    }

    private void writeFix(Fix fix) throws IOException {
        Map<String, List<TextEdit>> byFile = new LinkedHashMap<>();
        for (TextEdit edit : fix.edits()) {
            byFile.computeIfAbsent(edit.span().file().path(), p -> new ArrayList<>()).add(edit);
        }
        json.writeArrayFieldStart("fixes");
        json.writeStartObject();
        places.writeMessage("description", fix.title());
        json.writeArrayFieldStart("artifactChanges");
        for (List<TextEdit> edits : byFile.values()) {
            writeChange(edits);
        }
        json.writeEndArray();
        json.writeEndObject();
        json.writeEndArray();
    }

    private void writeChange(List<TextEdit> edits) throws IOException {
        json.writeStartObject();
        places.writeFile(edits.get(0).span());
        json.writeArrayFieldStart("replacements");
        for (TextEdit edit : edits) {
            json.writeStartObject();
            json.writeObjectFieldStart("deletedRegion");
            places.writeRange(edit.span());
            json.writeEndObject();
            json.writeObjectFieldStart("insertedContent");
            json.writeStringField("text", edit.text());
            json.writeEndObject();
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    /** What is suppressed in a model was not compared with a baseline. */
    private void writeStanding(Reported result) throws IOException {
        Standing standing = result.standing();
        if (compared && standing != Standing.SUPPRESSED) {
            boolean known = standing == Standing.KNOWN;
            json.writeStringField("baselineState", known ? "unchanged" : "new");
        }
        json.writeArrayFieldStart("suppressions");
        switch (standing) {
            case NEW -> {}
            case SUPPRESSED -> writeSuppression("inSource", result.reason());
            case KNOWN -> writeSuppression("external", "It is in the baseline.");
        }
        json.writeEndArray();
    }

    private void writeSuppression(String kind, String reason) throws IOException {
        json.writeStartObject();
        json.writeStringField("kind", kind);
        json.writeStringField("justification", Printable.escapeKeepingLayout(reason));
        json.writeEndObject();
    }
}

package arcomat.report.verdict;

import arcomat.analysis.Change;
import arcomat.analysis.Gate;
import arcomat.report.finding.FindingsJson;
import arcomat.report.text.Json;
import arcomat.source.Diagnostic;
import arcomat.source.Span;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** What became of every component, unchanged ones included, for programs. */
public final class GateJson {
    private GateJson() {}

    public static String render(Gate gate, List<Diagnostic> findings) {
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeStringField("verdict", VerdictText.word(gate.answer()));
                    json.writeArrayFieldStart("components");
                    for (Gate.Entry entry : gate.entries()) {
                        write(json, entry);
                    }
                    json.writeEndArray();
                    FindingsJson.write(json, "findings", findings);
                    json.writeEndObject();
                });
    }

    private static void write(JsonGenerator json, Gate.Entry entry) throws IOException {
        json.writeStartObject();
        json.writeStringField("name", entry.name());
        json.writeStringField("relation", GateText.word(entry.change().relation()));
        json.writeStringField("reason", entry.change().reason());
        if (entry.excuse().isPresent()) {
            json.writeStringField("excuse", entry.excuse().get());
        }
        if (entry.cause().isPresent()) {
            json.writeStringField("cause", entry.cause().get());
        }
        place(json, "old", entry.old());
        place(json, "new", entry.fresh());
        json.writeArrayFieldStart("witnesses");
        for (Change.Witness each : entry.change().witnesses()) {
            json.writeStartObject();
            json.writeStringField("left", each.left());
            json.writeStringField("right", each.right());
            VerdictJson.write(json, each.verdict());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void place(JsonGenerator json, String field, Optional<Span> place)
            throws IOException {
        if (place.isPresent()) {
            json.writeObjectFieldStart(field);
            json.writeStringField("file", place.get().file().path());
            json.writeNumberField("line", place.get().startPosition().line());
            json.writeNumberField("column", place.get().startPosition().column());
            json.writeEndObject();
        }
    }
}

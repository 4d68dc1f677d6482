package arcomat.report.verdict;

import arcomat.analysis.evolution.Evolution;
import arcomat.analysis.evolution.Evolution.Break;
import arcomat.analysis.evolution.Evolution.Culprit;
import arcomat.analysis.refinement.Verdict;
import arcomat.report.text.Json;
import arcomat.source.Span;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;

/** The matrix of verdicts along versions, for programs; versions are counted from 1. */
public final class EvolutionJson {
    private EvolutionJson() {}

    public static String render(Evolution evolution) {
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeArrayFieldStart("versions");
                    for (int i = 0; i < evolution.titles().size(); i++) {
                        version(json, evolution.titles().get(i), evolution.verdicts().get(i));
                    }
                    json.writeEndArray();
                    json.writeArrayFieldStart("breaks");
                    for (Break each : evolution.breaks()) {
                        write(json, each);
                    }
                    json.writeEndArray();
                    json.writeEndObject();
                });
    }

    private static void version(JsonGenerator json, String title, List<Verdict> verdicts)
            throws IOException {
        json.writeStartObject();
        json.writeStringField("name", title);
        json.writeArrayFieldStart("refines");
        for (Verdict verdict : verdicts) {
            json.writeString(VerdictText.word(verdict.answer()));
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, Break each) throws IOException {
        json.writeStartObject();
        json.writeNumberField("version", each.version() + 1);
        json.writeNumberField("promise", each.promise() + 1);
        VerdictJson.write(json, each.verdict());
        json.writeArrayFieldStart("edits");
        for (Culprit culprit : each.culprits()) {
            json.writeStartObject();
            if (culprit.old().isPresent()) {
                place(json, "was", culprit.old().get());
            }
            if (culprit.fresh().isPresent()) {
                place(json, "is", culprit.fresh().get());
            }
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void place(JsonGenerator json, String field, Span span) throws IOException {
        json.writeObjectFieldStart(field);
        json.writeStringField("text", span.text());
        json.writeStringField("file", span.file().path());
        json.writeNumberField("line", span.startPosition().line());
        json.writeEndObject();
    }
}

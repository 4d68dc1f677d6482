package arcomat.report.verdict;

import arcomat.analysis.evolution.Change;
import arcomat.analysis.evolution.Gate;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.report.finding.FindingsJson;
import arcomat.report.text.Json;
import arcomat.source.Diagnostic;
import arcomat.source.Span;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What became of every component, unchanged ones included, for programs. */
public final class GateJson {
    private GateJson() {}

    /**
     * The same as text.
     *
     * @param unread findings about files that are left out
     * @param leftOut their paths
     */
    public static String render(
            Gate gate, List<Diagnostic> findings, List<Diagnostic> unread, List<String> leftOut) {
        Answer answer = leftOut.isEmpty() ? gate.answer() : gate.answer().and(Answer.UNKNOWN);
        List<Diagnostic> all = new ArrayList<>(unread);
        all.addAll(findings);
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeStringField("verdict", VerdictText.word(answer));
                    json.writeArrayFieldStart("components");
                    for (Gate.Entry entry : gate.entries()) {
                        write(json, entry);
                    }
                    json.writeEndArray();
                    FindingsJson.write(json, "findings", all);
                    if (!leftOut.isEmpty()) {
                        json.writeArrayFieldStart("leftOut");
                        for (String path : leftOut) {
                            json.writeString(path);
                        }
                        json.writeEndArray();
                    }
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

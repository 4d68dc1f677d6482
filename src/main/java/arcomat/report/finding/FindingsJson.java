package arcomat.report.finding;

import arcomat.report.finding.Baseline.Entry;
import arcomat.report.text.Json;
import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Position;
import arcomat.source.Related;
import arcomat.source.Span;
import arcomat.source.Suppressed;
import arcomat.source.TextEdit;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;

/**
 * Findings for programs. Lines and columns count from 1 as in the text output; {@code offset}
 * counts UTF-16 units from 0; ends are exclusive.
 */
public final class FindingsJson {
    private FindingsJson() {}

    public static String render(CheckReport report) {
        List<Diagnostic> findings = report.findings();
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeNumberField("files", report.paths().size());
                    json.writeNumberField(
                            "errors", findings.stream().filter(Diagnostic::isError).count());
                    json.writeNumberField(
                            "warnings", findings.stream().filter(d -> !d.isError()).count());
                    write(json, "findings", findings);
                    write(json, report.suppressed());
                    if (report.comparison().isPresent()) {
                        write(json, "known", report.known());
                        write(json, report.comparison().get().gone());
                    }
                    json.writeEndObject();
                });
    }

    /** A field with a list of findings. */
    public static void write(JsonGenerator json, String field, List<Diagnostic> findings)
            throws IOException {
        json.writeArrayFieldStart(field);
        for (Diagnostic finding : findings) {
            json.writeStartObject();
            writeFields(json, finding);
            json.writeEndObject();
        }
        json.writeEndArray();
    }

    private static void write(JsonGenerator json, List<Suppressed> suppressed) throws IOException {
        json.writeArrayFieldStart("suppressed");
        for (Suppressed each : suppressed) {
            json.writeStartObject();
            writeFields(json, each.finding());
            json.writeStringField("reason", each.reason());
            json.writeEndObject();
        }
        json.writeEndArray();
    }

    private static void write(JsonGenerator json, SortedMap<Entry, Integer> gone)
            throws IOException {
        json.writeArrayFieldStart("gone");
        for (Map.Entry<Entry, Integer> each : gone.entrySet()) {
            json.writeStartObject();
            json.writeStringField("code", each.getKey().code());
            json.writeStringField("file", each.getKey().path());
            json.writeStringField("fingerprint", each.getKey().fingerprint());
            json.writeNumberField("times", each.getValue());
            json.writeEndObject();
        }
        json.writeEndArray();
    }

    /** Into an object that has been started. */
    public static void writeFields(JsonGenerator json, Diagnostic finding) throws IOException {
        json.writeStringField("code", finding.code());
        json.writeStringField("severity", FindingsText.word(finding.severity()));
        json.writeStringField("message", finding.message());
        writePlace(json, finding.span());
        json.writeArrayFieldStart("related");
        for (Related related : finding.related()) {
            json.writeStartObject();
            json.writeStringField("note", related.note());
            writePlace(json, related.span());
            json.writeEndObject();
        }
        json.writeEndArray();
        if (finding.fix().isPresent()) {
            write(json, finding.fix().get());
        }
    }

    private static void write(JsonGenerator json, Fix fix) throws IOException {
        json.writeObjectFieldStart("fix");
        json.writeStringField("title", fix.title());
        json.writeArrayFieldStart("edits");
        for (TextEdit edit : fix.edits()) {
            json.writeStartObject();
            writePlace(json, edit.span());
            json.writeStringField("text", edit.text());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void writePlace(JsonGenerator json, Span span) throws IOException {
        json.writeStringField("file", span.file().path());
        writePosition(json, "start", span.startPosition(), span.start());
        writePosition(json, "end", span.endPosition(), span.end());
    }

    private static void writePosition(
            JsonGenerator json, String field, Position position, int offset) throws IOException {
        json.writeObjectFieldStart(field);
        json.writeNumberField("line", position.line());
        json.writeNumberField("column", position.column());
        json.writeNumberField("offset", offset);
        json.writeEndObject();
    }
}

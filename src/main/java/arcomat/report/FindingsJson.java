package arcomat.report;

import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Position;
import arcomat.source.Related;
import arcomat.source.Span;
import arcomat.source.TextEdit;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;

/**
 * Findings for programs. Lines and columns count from 1 as in the text output; {@code offset}
 * counts UTF-16 units from 0; ends are exclusive.
 */
public final class FindingsJson {
    private FindingsJson() {}

    public static String render(List<Diagnostic> findings, int files) {
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeNumberField("files", files);
                    json.writeNumberField(
                            "errors", findings.stream().filter(Diagnostic::isError).count());
                    json.writeNumberField(
                            "warnings", findings.stream().filter(d -> !d.isError()).count());
                    json.writeArrayFieldStart("findings");
                    for (Diagnostic finding : findings) {
                        write(json, finding);
                    }
                    json.writeEndArray();
                    json.writeEndObject();
                });
    }

    private static void write(JsonGenerator json, Diagnostic finding) throws IOException {
        json.writeStartObject();
        writeFields(json, finding);
        json.writeEndObject();
    }

    /** Into an object that has been started. */
    static void writeFields(JsonGenerator json, Diagnostic finding) throws IOException {
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

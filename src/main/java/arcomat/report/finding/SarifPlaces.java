package arcomat.report.finding;

import arcomat.report.text.Printable;
import arcomat.source.Position;
import arcomat.source.Span;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.Optional;

/** Places as SARIF writes them; columns count UTF-16 units from 1, ends are exclusive. */
record SarifPlaces(JsonGenerator json, SourceRoot root) {
    private static final String BASE = "%SRCROOT%";

    /** What relative URIs count from; where that is, nobody else needs to know. */
    void writeBases() throws IOException {
        json.writeObjectFieldStart("originalUriBaseIds");
        json.writeObjectFieldStart(BASE);
        writeMessage("description", "The folder that arcomat was started in.");
        json.writeEndObject();
        json.writeEndObject();
    }

    /**
     * A location, as an element of an array.
     *
     * @param note what is to be seen there
     */
    void writeLocation(Span span, Optional<String> note) throws IOException {
        json.writeStartObject();
        writeLocationFields(span, note);
        json.writeEndObject();
    }

    void writeLocationFields(Span span, Optional<String> note) throws IOException {
        json.writeObjectFieldStart("physicalLocation");
        writeFile(span);
        // A file that cannot be read has no lines.
        if (!span.file().text().isEmpty()) {
            json.writeObjectFieldStart("region");
            writeRange(span);
            json.writeEndObject();
        }
        json.writeEndObject();
        if (note.isPresent()) {
            writeMessage("message", note.get());
        }
    }

    /** The field {@code artifactLocation}. */
    void writeFile(Span span) throws IOException {
        String path = span.file().path();
        json.writeObjectFieldStart("artifactLocation");
        json.writeStringField("uri", root.uri(path));
        if (SourceRoot.isRelative(root.relative(path))) {
            json.writeStringField("uriBaseId", BASE);
        }
        json.writeEndObject();
    }

    /** The fields of a region. */
    void writeRange(Span span) throws IOException {
        Position start = span.startPosition();
        Position end = span.endPosition();
        json.writeNumberField("startLine", start.line());
        json.writeNumberField("startColumn", start.column());
        json.writeNumberField("endLine", end.line());
        json.writeNumberField("endColumn", end.column());
    }

    /** Braces hold places for arguments in SARIF; those of models are doubled (section 3.11.5). */
    void writeMessage(String field, String text) throws IOException {
        String safe = Printable.escapeKeepingLayout(text.strip());
        json.writeObjectFieldStart(field);
        json.writeStringField("text", safe.replace("{", "{{").replace("}", "}}"));
        json.writeEndObject();
    }
}

package arcomat.report.finding;

import arcomat.report.finding.CheckState.File;
import arcomat.report.finding.CheckState.Names;
import arcomat.report.text.Json;
import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Related;
import arcomat.source.Span;
import arcomat.source.Suppressed;
import arcomat.source.TextEdit;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.Collection;
import java.util.Map;
import java.util.TreeMap;

/**
 * Writes the state of a check, one file a line. Only the tool that wrote it reads it, through
 * {@link CheckStateReader}: what is known by its position has no name, since reading the state is
 * most of the work where little has changed.
 */
public final class CheckStateJson {
    private CheckStateJson() {}

    public static String render(CheckState state) {
        return Json.compact(json -> write(json, state));
    }

    private static void write(JsonGenerator json, CheckState state) throws IOException {
        json.writeStartArray();
        json.writeString(state.key());
        json.writeStartArray();
        for (Map.Entry<String, String> folder : new TreeMap<>(state.folders()).entrySet()) {
            json.writeString(folder.getKey());
            json.writeString(folder.getValue());
        }
        json.writeEndArray();
        json.writeStartArray();
        for (File file : state.files()) {
            json.writeRaw('\n');
            write(json, file);
        }
        json.writeEndArray();
        json.writeEndArray();
    }

    private static void write(JsonGenerator json, File file) throws IOException {
        json.writeStartArray();
        json.writeString(file.path());
        json.writeString(file.hash());
        json.writeBoolean(file.named());
        write(json, file.needs());
        write(json, file.names().orElse(null));
        json.writeString(String.join(" ", file.mentions()));
        json.writeStartArray();
        for (Diagnostic finding : file.findings()) {
            write(json, finding);
        }
        json.writeEndArray();
        json.writeStartArray();
        for (Suppressed each : file.suppressed()) {
            write(json, each.finding());
            json.writeString(each.reason());
        }
        json.writeEndArray();
        json.writeEndArray();
    }

    private static void write(JsonGenerator json, Collection<String> texts) throws IOException {
        json.writeStartArray();
        for (String text : texts) {
            json.writeString(text);
        }
        json.writeEndArray();
    }

    private static void write(JsonGenerator json, Names names) throws IOException {
        if (names == null) {
            json.writeNull();
            return;
        }
        json.writeStartArray();
        json.writeString(names.packageName());
        write(json, names.components());
        json.writeString(names.diagram().orElse(""));
        write(json, names.types());
        json.writeEndArray();
    }

    private static void write(JsonGenerator json, Diagnostic finding) throws IOException {
        json.writeStartArray();
        json.writeString(finding.code());
        json.writeBoolean(finding.isError());
        write(json, finding.span());
        json.writeString(finding.message());
        json.writeStartArray();
        for (Related related : finding.related()) {
            write(json, related.span());
            json.writeString(related.note());
        }
        json.writeEndArray();
        write(json, finding.fix().orElse(null));
        json.writeEndArray();
    }

    private static void write(JsonGenerator json, Fix fix) throws IOException {
        if (fix == null) {
            json.writeNull();
            return;
        }
        json.writeStartArray();
        json.writeString(fix.title());
        for (TextEdit edit : fix.edits()) {
            write(json, edit.span());
            json.writeString(edit.text());
        }
        json.writeEndArray();
    }

    private static void write(JsonGenerator json, Span span) throws IOException {
        json.writeString(span.file().path());
        json.writeNumber(span.start());
        json.writeNumber(span.end());
    }
}

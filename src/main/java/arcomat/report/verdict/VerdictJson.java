package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Moment;
import arcomat.model.Letter;
import arcomat.model.Value;
import arcomat.report.run.TraceJson;
import arcomat.report.text.Json;
import arcomat.semantics.expression.Sent;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * A verdict for programs. Silent ports are left out; {@code "*"} is an output that is left open.
 */
public final class VerdictJson {
    private VerdictJson() {}

    public static String render(Verdict verdict) {
        return Json.text(
                json -> {
                    json.writeStartObject();
                    write(json, verdict);
                    json.writeEndObject();
                });
    }

    /** Answers to many questions, with the names of both sides. */
    public static String render(List<Answered> answers) {
        return Json.text(
                json -> {
                    json.writeStartArray();
                    for (Answered each : answers) {
                        json.writeStartObject();
                        json.writeStringField(
                                "question", each.question().name().toLowerCase(Locale.ROOT));
                        json.writeStringField("left", each.left());
                        json.writeStringField("right", each.right());
                        write(json, each.verdict());
                        json.writeEndObject();
                    }
                    json.writeEndArray();
                });
    }

    /** The fields of a verdict, into an object that has been started. */
    static void write(JsonGenerator json, Verdict verdict) throws IOException {
        json.writeStringField("verdict", VerdictText.word(verdict.answer()));
        json.writeStringField("reason", verdict.reason());
        if (verdict.simulation().isPresent()) {
            json.writeBooleanField("simulation", verdict.simulation().get());
        }
        json.writeArrayFieldStart("trace");
        for (Moment moment : verdict.trace()) {
            write(json, moment);
        }
        json.writeEndArray();
        json.writeArrayFieldStart("explanation");
        for (Sentence sentence : verdict.explanation()) {
            write(json, sentence);
        }
        json.writeEndArray();
        Json.strings(json, "notes", verdict.notes());
        json.writeObjectFieldStart("explored");
        json.writeNumberField("pairs", verdict.explored().pairs());
        json.writeNumberField("left", verdict.explored().left());
        json.writeNumberField("right", verdict.explored().right());
        json.writeEndObject();
    }

    static void write(JsonGenerator json, Moment moment) throws IOException {
        json.writeStartObject();
        input(json, moment.input());
        outputs(json, moment.outputs());
        if (moment.error()) {
            json.writeBooleanField("error", true);
        }
        json.writeStringField("left", moment.left());
        Json.strings(json, "right", moment.right());
        json.writeEndObject();
    }

    /** The field {@code in}. */
    static void input(JsonGenerator json, Letter letter) throws IOException {
        json.writeObjectFieldStart("in");
        for (Map.Entry<String, List<Value>> port : letter.messages().entrySet()) {
            json.writeFieldName(port.getKey());
            messages(json, port.getValue());
        }
        json.writeEndObject();
    }

    /** The field {@code out}. */
    static void outputs(JsonGenerator json, Map<String, Sent> outputs) throws IOException {
        json.writeObjectFieldStart("out");
        for (Map.Entry<String, Sent> port : outputs.entrySet()) {
            sent(json, port.getKey(), port.getValue());
        }
        json.writeEndObject();
    }

    private static void sent(JsonGenerator json, String port, Sent sent) throws IOException {
        if (!(sent instanceof Sent.Messages messages)) {
            json.writeStringField(port, "*");
        } else if (!messages.values().isEmpty()) {
            json.writeFieldName(port);
            messages(json, messages.values());
        }
    }

    /** Event-driven, a port may carry several messages. */
    private static void messages(JsonGenerator json, List<Value> values) throws IOException {
        if (values.size() == 1) {
            TraceJson.write(json, values.get(0));
            return;
        }
        json.writeStartArray();
        for (Value value : values) {
            TraceJson.write(json, value);
        }
        json.writeEndArray();
    }

    static void write(JsonGenerator json, Sentence sentence) throws IOException {
        json.writeStartObject();
        json.writeStringField("text", sentence.text());
        if (sentence.place().isPresent()) {
            json.writeStringField("file", sentence.place().get().file().path());
            json.writeNumberField("line", sentence.place().get().startPosition().line());
            json.writeNumberField("column", sentence.place().get().startPosition().column());
        }
        json.writeEndObject();
    }
}

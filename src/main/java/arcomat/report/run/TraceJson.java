package arcomat.report.run;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.report.text.Json;
import arcomat.source.Span;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * A trace for programs. Messages are lists, for an event may send several; values are written as in
 * models, but for numbers and truth values.
 */
public final class TraceJson implements RunText {
    private final Consumer<String> out;
    private final Json.Growing text = new Json.Growing();

    /**
     * @param out takes the text, step by step
     */
    public TraceJson(Consumer<String> out) {
        this.out = out;
    }

    @Override
    public void begin(Component component, TraceColumns columns) {
        out.accept(
                text.add(
                        json -> {
                            json.writeStartObject();
                            json.writeStringField("component", component.qualifiedName());
                            json.writeStringField("unit", columns.unit());
                            json.writeArrayFieldStart("steps");
                        }));
    }

    @Override
    public void step(Trace.Step step) {
        out.accept(text.add(json -> write(json, step)));
    }

    @Override
    public void end(int steps, Trace rest) {
        out.accept(
                text.add(
                        json -> {
                            json.writeEndArray();
                            if (RunText.endsInError(rest)) {
                                writeEnd(json, steps, rest);
                            }
                            if (rest.failure().isPresent()) {
                                json.writeStringField("failure", rest.failure().get());
                            }
                            json.writeEndObject();
                        }));
        out.accept("\n");
    }

    /** The step that goes wrong, with what was sent before it. */
    private static void writeEnd(JsonGenerator json, int number, Trace rest) throws IOException {
        json.writeObjectFieldStart("end");
        json.writeNumberField("number", number);
        writeLetter(json, "inputs", RunText.lastInputs(rest));
        writeLetter(json, "outputs", RunText.lastOutputs(rest));
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, Trace.Step step) throws IOException {
        json.writeStartObject();
        json.writeNumberField("number", step.number());
        writeLetter(json, "inputs", step.inputs());
        writeLetter(json, "outputs", step.outputs());
        json.writeArrayFieldStart("activities");
        for (Trace.Activity activity : step.activities()) {
            write(json, activity);
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, Trace.Activity activity) throws IOException {
        json.writeStartObject();
        json.writeStringField("instance", activity.instance());
        json.writeStringField("automaton", activity.automaton());
        json.writeStringField("before", activity.before());
        json.writeStringField("after", activity.after());
        if (activity.cause() instanceof Trace.Taken taken) {
            Span span = taken.transition().span();
            json.writeNumberField("transition", taken.index());
            json.writeStringField("file", span.file().path());
            json.writeNumberField("line", span.startPosition().line());
        } else if (activity.cause() instanceof Trace.Completed completed) {
            json.writeStringField("completion", CauseText.name(completed.completion()));
        }
        json.writeObjectFieldStart("variables");
        for (Map.Entry<String, Value> variable : activity.variables().entrySet()) {
            json.writeFieldName(variable.getKey());
            write(json, variable.getValue());
        }
        json.writeEndObject();
        json.writeEndObject();
    }

    private static void writeLetter(JsonGenerator json, String field, Letter letter)
            throws IOException {
        json.writeObjectFieldStart(field);
        for (Map.Entry<String, List<Value>> port : letter.messages().entrySet()) {
            json.writeArrayFieldStart(port.getKey());
            for (Value value : port.getValue()) {
                write(json, value);
            }
            json.writeEndArray();
        }
        json.writeEndObject();
    }

    public static void write(JsonGenerator json, Value value) throws IOException {
        if (value instanceof Value.BooleanValue truth) {
            json.writeBoolean(truth.value());
        } else if (value instanceof Value.IntegerValue number) {
            json.writeNumber(number.value());
        } else if (value instanceof Value.RealValue number && Double.isFinite(number.value())) {
            json.writeNumber(number.value());
        } else if (value instanceof Value.StringValue string) {
            json.writeString(string.value());
        } else {
            json.writeString(value.toString());
        }
    }
}

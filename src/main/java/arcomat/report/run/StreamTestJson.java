package arcomat.report.run;

import arcomat.model.Value;
import arcomat.report.text.Json;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTestResult.Cell;
import arcomat.simulate.test.StreamTestResult.Verdict;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;
import java.util.Locale;

/** Results of stream tests for programs, with the streams of every test slice by slice. */
public final class StreamTestJson {
    private StreamTestJson() {}

    public static String render(List<StreamTestResult> results) {
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeArrayFieldStart("tests");
                    for (StreamTestResult result : results) {
                        write(json, result);
                    }
                    json.writeEndArray();
                    json.writeEndObject();
                });
    }

    private static void write(JsonGenerator json, StreamTestResult result) throws IOException {
        json.writeStartObject();
        json.writeStringField("file", result.test().span().file().path());
        json.writeNumberField("line", result.test().span().startPosition().line());
        json.writeStringField("suite", result.test().suite());
        json.writeStringField("name", result.test().name());
        json.writeStringField("verdict", result.verdict().name().toLowerCase(Locale.ROOT));
        if (result.failure().isPresent()) {
            boolean unknown = result.verdict() == Verdict.UNKNOWN;
            json.writeStringField(unknown ? "reason" : "failure", result.failure().get());
        }
        if (result.firstDifference().isPresent()) {
            json.writeNumberField("firstDifference", result.firstDifference().getAsInt());
        }
        json.writeArrayFieldStart("streams");
        for (Cell cell : result.cells()) {
            json.writeStartObject();
            json.writeNumberField("slice", cell.slice());
            json.writeStringField("port", cell.port());
            write(json, "expected", cell.expected());
            write(json, "actual", cell.actual());
            json.writeBooleanField("differs", cell.differs());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, String field, List<Value> values)
            throws IOException {
        json.writeArrayFieldStart(field);
        for (Value value : values) {
            TraceJson.write(json, value);
        }
        json.writeEndArray();
    }
}

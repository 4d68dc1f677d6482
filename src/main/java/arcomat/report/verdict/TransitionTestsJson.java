package arcomat.report.verdict;

import arcomat.analysis.coverage.Goal;
import arcomat.analysis.coverage.TransitionTests;
import arcomat.analysis.coverage.TransitionTests.Mistake;
import arcomat.analysis.coverage.TransitionTests.Uncovered;
import arcomat.analysis.coverage.TransitionTests.Untold;
import arcomat.report.text.Json;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;

/** Tests that were made, for programs. */
public final class TransitionTestsJson {
    private TransitionTestsJson() {}

    /**
     * @param file where the tests were written; empty where there are none
     */
    public static String render(String file, TransitionTests.Result found) {
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeStringField("verdict", VerdictText.word(found.answer()));
                    json.writeStringField("reason", found.stopped().orElse(""));
                    json.writeStringField("suite", file);
                    json.writeArrayFieldStart("tests");
                    for (TransitionTests.Test test : found.tests()) {
                        write(json, test);
                    }
                    json.writeEndArray();
                    json.writeArrayFieldStart("notTaken");
                    for (Uncovered uncovered : found.uncovered()) {
                        json.writeStartObject();
                        write(json, uncovered.transition());
                        json.writeStringField("reason", uncovered.reason());
                        json.writeEndObject();
                    }
                    json.writeEndArray();
                    json.writeArrayFieldStart("notTold");
                    for (Untold untold : found.untold()) {
                        json.writeStartObject();
                        write(json, untold.mistake());
                        json.writeStringField("reason", untold.reason());
                        json.writeBooleanField("certain", untold.certain());
                        json.writeEndObject();
                    }
                    json.writeEndArray();
                    json.writeObjectFieldStart("explored");
                    json.writeNumberField("configurations", found.configurations());
                    json.writeEndObject();
                    json.writeEndObject();
                });
    }

    private static void write(JsonGenerator json, TransitionTests.Test test) throws IOException {
        json.writeStartObject();
        json.writeStringField("name", test.streams().name());
        json.writeNumberField("letters", test.streams().inputs().size());
        json.writeArrayFieldStart("takes");
        for (Goal goal : test.covers()) {
            json.writeStartObject();
            write(json, goal);
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeBooleanField("promised", test.promised());
        if (test.tells().isPresent()) {
            json.writeObjectFieldStart("tells");
            write(json, test.tells().get());
            json.writeEndObject();
        }
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, Mistake mistake) throws IOException {
        write(json, mistake.transition());
        json.writeStringField("mistake", mistake.what());
    }

    private static void write(JsonGenerator json, Goal goal) throws IOException {
        json.writeStringField("automaton", goal.automaton().name());
        json.writeStringField("from", goal.source());
        json.writeStringField("to", goal.target());
        json.writeNumberField("line", goal.transition().span().startPosition().line());
    }
}

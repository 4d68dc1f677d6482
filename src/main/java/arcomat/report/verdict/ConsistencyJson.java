package arcomat.report.verdict;

import arcomat.analysis.contradiction.Consistency;
import arcomat.analysis.contradiction.Contradiction;
import arcomat.analysis.game.Turn;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.model.Letter;
import arcomat.report.text.Json;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.Optional;

/** Contradictions, or the controller that shows that there are none, for programs. */
public final class ConsistencyJson {
    private ConsistencyJson() {}

    /**
     * @param controller its text
     * @param file where that was written
     */
    public static String render(
            Consistency found, Optional<String> controller, Optional<String> file) {
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeStringField("verdict", VerdictText.word(found.answer()));
                    boolean fails = found.answer() == Answer.FAILS;
                    json.writeStringField("reason", fails ? "contradiction" : found.reason());
                    json.writeArrayFieldStart("contradictions");
                    for (Contradiction contradiction : found.contradictions()) {
                        write(json, contradiction);
                    }
                    json.writeEndArray();
                    if (controller.isPresent()) {
                        json.writeStringField("controller", controller.get());
                    }
                    if (file.isPresent()) {
                        json.writeStringField("file", file.get());
                    }
                    Json.strings(json, "notes", found.notes());
                    json.writeObjectFieldStart("explored");
                    json.writeNumberField("positions", found.explored());
                    json.writeEndObject();
                    json.writeEndObject();
                });
    }

    private static void write(JsonGenerator json, Contradiction contradiction) throws IOException {
        json.writeStartObject();
        Json.strings(json, "requirements", ConsistencyText.names(contradiction));
        json.writeBooleanField("minimal", contradiction.minimal());
        if (contradiction.word().isPresent()) {
            json.writeArrayFieldStart("word");
            for (Letter letter : contradiction.word().get()) {
                json.writeStartObject();
                VerdictJson.input(json, letter);
                json.writeEndObject();
            }
            json.writeEndArray();
        }
        json.writeArrayFieldStart("steps");
        for (Contradiction.Step step : contradiction.steps()) {
            write(json, step);
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, Contradiction.Step step) throws IOException {
        json.writeStartObject();
        VerdictJson.input(json, step.input());
        json.writeArrayFieldStart("answers");
        for (Turn.Answer answer : step.answers()) {
            json.writeStartObject();
            VerdictJson.outputs(json, answer.outputs());
            json.writeNumberField("then", answer.next());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeArrayFieldStart("demands");
        for (Sentence sentence : step.demands()) {
            VerdictJson.write(json, sentence);
        }
        json.writeEndArray();
        json.writeEndObject();
    }
}

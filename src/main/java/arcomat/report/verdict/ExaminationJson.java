package arcomat.report.verdict;

import arcomat.analysis.automaton.Examination;
import arcomat.analysis.automaton.Examination.Unexamined;
import arcomat.analysis.automaton.Finding;
import arcomat.analysis.search.Moment;
import arcomat.model.Letter;
import arcomat.report.finding.FindingsJson;
import arcomat.report.text.Json;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;

/**
 * Findings about automata for programs: one entry per automaton, with a verdict. The last letter of
 * a trace has no {@code out} where the finding is about what may follow it.
 */
public final class ExaminationJson {
    private ExaminationJson() {}

    public static String render(List<Examination> examinations, List<Unexamined> unexamined) {
        return Json.text(
                json -> {
                    json.writeStartArray();
                    for (Examination examination : examinations) {
                        write(json, examination);
                    }
                    for (Unexamined each : unexamined) {
                        write(json, each);
                    }
                    json.writeEndArray();
                });
    }

    /** With the same fields as what was examined. */
    private static void write(JsonGenerator json, Unexamined unexamined) throws IOException {
        json.writeStartObject();
        json.writeStringField("component", unexamined.component());
        json.writeStringField("automaton", "");
        json.writeStringField("title", unexamined.component());
        json.writeStringField("verdict", "unknown");
        json.writeStringField("reason", unexamined.reason());
        Json.strings(json, "findings", List.of());
        writeExplored(json, 0);
        json.writeEndObject();
    }

    private static void writeExplored(JsonGenerator json, int configurations) throws IOException {
        json.writeObjectFieldStart("explored");
        json.writeNumberField("configurations", configurations);
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, Examination examination) throws IOException {
        json.writeStartObject();
        json.writeStringField("component", examination.component().qualifiedName());
        json.writeStringField("automaton", examination.automaton().name());
        json.writeStringField("title", ExaminationText.title(examination));
        json.writeStringField("verdict", VerdictText.word(examination.answer()));
        json.writeStringField("reason", examination.obstacle());
        json.writeArrayFieldStart("findings");
        for (Finding finding : examination.findings()) {
            write(json, finding);
        }
        json.writeEndArray();
        writeExplored(json, examination.explored());
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, Finding finding) throws IOException {
        json.writeStartObject();
        FindingsJson.writeFields(json, finding.diagnostic());
        json.writeArrayFieldStart("trace");
        for (Moment moment : finding.trace()) {
            json.writeStartObject();
            VerdictJson.input(json, moment.input());
            VerdictJson.outputs(json, moment.outputs());
            json.writeStringField("state", moment.left());
            json.writeEndObject();
        }
        if (finding.witness().isPresent()) {
            Letter witness = finding.witness().get();
            json.writeStartObject();
            VerdictJson.input(json, witness);
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }
}

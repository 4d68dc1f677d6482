package arcomat.report;

import arcomat.analysis.Moment;
import arcomat.analysis.automaton.Examination;
import arcomat.analysis.automaton.Finding;
import arcomat.model.Letter;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;
import java.util.Locale;

/**
 * Findings about automata for programs: one entry per automaton, with a verdict. The last letter of
 * a trace has no {@code out} where the finding is about what may follow it.
 */
public final class ExaminationJson {
    private ExaminationJson() {}

    public static String render(List<Examination> examinations) {
        return Json.text(
                json -> {
                    json.writeStartArray();
                    for (Examination examination : examinations) {
                        write(json, examination);
                    }
                    json.writeEndArray();
                });
    }

    private static void write(JsonGenerator json, Examination examination) throws IOException {
        json.writeStartObject();
        json.writeStringField("component", examination.component().qualifiedName());
        json.writeStringField("automaton", examination.automaton().name());
        json.writeStringField("title", ExaminationText.title(examination));
        json.writeStringField("verdict", examination.answer().name().toLowerCase(Locale.ROOT));
        json.writeStringField("reason", examination.obstacle());
        json.writeArrayFieldStart("findings");
        for (Finding finding : examination.findings()) {
            write(json, finding);
        }
        json.writeEndArray();
        json.writeArrayFieldStart("notes");
        for (String note : examination.notes()) {
            json.writeString(note);
        }
        json.writeEndArray();
        json.writeObjectFieldStart("explored");
        json.writeNumberField("configurations", examination.explored());
        json.writeEndObject();
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

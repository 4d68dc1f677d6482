package arcomat.report.verdict;

import arcomat.analysis.refinement.Difference;
import arcomat.analysis.refinement.Verdict;
import arcomat.report.text.Json;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;
import java.util.Locale;

/** How two components compare, for programs. */
public final class DifferenceJson {
    private DifferenceJson() {}

    public static String render(String left, String right, Difference difference) {
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeStringField("left", left);
                    json.writeStringField("right", right);
                    json.writeStringField(
                            "relation",
                            difference
                                    .relation()
                                    .name()
                                    .toLowerCase(Locale.ROOT)
                                    .replace('_', ' '));
                    write(json, "forward", difference.forward());
                    write(json, "backward", difference.backward());
                    json.writeEndObject();
                });
    }

    private static void write(JsonGenerator json, String field, List<Verdict> verdicts)
            throws IOException {
        json.writeArrayFieldStart(field);
        for (Verdict verdict : verdicts) {
            json.writeStartObject();
            VerdictJson.write(json, verdict);
            json.writeEndObject();
        }
        json.writeEndArray();
    }
}

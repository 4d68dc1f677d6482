package arcomat.report;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;

/** A monitor that was written, for programs. */
public final class MonitorJson {
    private MonitorJson() {}

    /**
     * @param className of the class to use
     * @param files paths in the output folder
     */
    public static String render(String className, List<String> requirements, List<String> files) {
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeStringField("class", className);
                    strings(json, "requirements", requirements);
                    strings(json, "files", files);
                    json.writeEndObject();
                });
    }

    private static void strings(JsonGenerator json, String field, List<String> all)
            throws IOException {
        json.writeArrayFieldStart(field);
        for (String each : all) {
            json.writeString(each);
        }
        json.writeEndArray();
    }
}

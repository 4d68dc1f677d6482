package arcomat.report.run;

import arcomat.report.text.Json;

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
                    Json.strings(json, "requirements", requirements);
                    Json.strings(json, "files", files);
                    json.writeEndObject();
                });
    }
}

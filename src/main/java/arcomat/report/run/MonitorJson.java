package arcomat.report.run;

import arcomat.report.text.Json;

import com.fasterxml.jackson.annotation.JsonProperty;

import java.util.List;

/**
 * A monitor that was written, for programs.
 *
 * @param className of the class to use
 * @param files paths in the output folder
 */
public record MonitorJson(
        @JsonProperty("class") String className, List<String> requirements, List<String> files) {
    public static String render(String className, List<String> requirements, List<String> files) {
        return Json.text(new MonitorJson(className, requirements, files));
    }
}

package arcomat.report.verdict;

import arcomat.report.finding.FindingsText;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;

/** Says that a question for the program MONA has been written. */
public final class MonaReport {
    private MonaReport() {}

    /**
     * @param leftStates how many states of the left side the file spells out
     */
    public static String text(String file, int leftStates, int rightStates) {
        return "wrote %s: %s against %s; ask: mona -q %s\n"
                .formatted(
                        Printable.escape(file),
                        FindingsText.count(leftStates, "state"),
                        FindingsText.count(rightStates, "state"),
                        Printable.escape(file));
    }

    /** For programs. */
    public static String json(String file, int leftStates, int rightStates) {
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeStringField("file", file);
                    json.writeNumberField("leftStates", leftStates);
                    json.writeNumberField("rightStates", rightStates);
                    json.writeEndObject();
                });
    }
}

package arcomat.report.verdict;

import arcomat.report.finding.FindingsText;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;

/**
 * Says that a question for the program MONA has been written.
 *
 * @param leftStates how many states of the left side the file spells out
 */
public record MonaReport(String file, int leftStates, int rightStates) {
    public String text() {
        return "wrote %s: %s against %s; ask: mona -q %s\n"
                .formatted(
                        Printable.escape(file),
                        FindingsText.count(leftStates, "state"),
                        FindingsText.count(rightStates, "state"),
                        Printable.escape(file));
    }

    /** For programs. */
    public String json() {
        return Json.text(this);
    }
}

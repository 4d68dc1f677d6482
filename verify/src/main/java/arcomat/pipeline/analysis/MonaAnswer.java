package arcomat.pipeline.analysis;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What the program MONA says about a formula. */
sealed interface MonaAnswer {
    /** The formula is true of all strings. */
    record Valid() implements MonaAnswer {}

    /**
     * A shortest string of which it is not.
     *
     * @param rows one character per position for each variable: 0, 1, or X where it does not matter
     */
    record Counterexample(Map<String, String> rows) implements MonaAnswer {}

    /**
     * No answer.
     *
     * @param reason why not
     */
    record None(String reason) implements MonaAnswer {}

    /**
     * {@code name X bits}: the first column is for variables of order 0, of which there are none.
     */
    Pattern ROW = Pattern.compile("(\\S+)\\s+X ([01X]*)\\s*");

    Pattern LENGTH = Pattern.compile("A counter-example of least length \\(([0-9]{1,9})\\) is:");

    /** Reads what the program has printed. */
    static MonaAnswer read(String output) {
        List<String> lines = output.lines().toList();
        for (int i = 0; i < lines.size(); i++) {
            Matcher length = LENGTH.matcher(lines.get(i));
            if (length.matches()) {
                return rows(lines.subList(i + 1, lines.size()), Integer.parseInt(length.group(1)));
            }
            if (lines.get(i).equals("Formula is valid")) {
                return new Valid();
            }
        }
        return new None("MONA has given no answer that can be understood");
    }

    private static MonaAnswer rows(List<String> lines, int length) {
        Map<String, String> rows = new LinkedHashMap<>();
        for (String line : lines) {
            Matcher row = ROW.matcher(line);
            if (!row.matches()) {
                break;
            }
            rows.put(row.group(1), row.group(2));
        }
        return !rows.isEmpty() && rows.values().stream().allMatch(row -> row.length() == length)
                ? new Counterexample(rows)
                : new None("MONA has given a counterexample that cannot be understood");
    }
}

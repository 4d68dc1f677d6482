package arcomat.report.text;

import java.util.List;
import java.util.stream.Collectors;

/** A line of comma-separated values as RFC 4180 says. */
public final class CsvLine {
    private CsvLine() {}

    public static String of(List<String> fields) {
        return fields.stream().map(CsvLine::quoted).collect(Collectors.joining(",", "", "\n"));
    }

    private static String quoted(String field) {
        boolean plain = field.chars().noneMatch(c -> c == '"' || c == ',' || c < ' ');
        return plain ? field : '"' + field.replace("\"", "\"\"") + '"';
    }
}

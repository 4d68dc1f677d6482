package arcomat.report.text;

import arcomat.source.Signs;

import java.util.List;
import java.util.stream.Collectors;

/** Any text on one line of a file, and back again; several texts as a line of a table. */
public final class OneLine {
    private OneLine() {}

    public static String of(String text) {
        return text.replace("\\", "\\\\").replace("\n", "\\n").replace("\r", "\\r");
    }

    /** Comma-separated values as RFC 4180 says, with the line break. */
    public static String csv(List<String> fields) {
        return fields.stream().map(OneLine::quoted).collect(Collectors.joining(",", "", "\n"));
    }

    private static String quoted(String text) {
        String field = Signs.withoutDirections(text);
        boolean plain = field.chars().noneMatch(c -> c == '"' || c == ',' || c < ' ');
        return plain ? field : '"' + field.replace("\"", "\"\"") + '"';
    }

    /** The text that a line was made of. */
    public static String read(String line) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < line.length(); i++) {
            char c = line.charAt(i);
            if (c == '\\' && i + 1 < line.length()) {
                char next = line.charAt(++i);
                text.append(next == 'n' ? '\n' : next == 'r' ? '\r' : next);
            } else {
                text.append(c);
            }
        }
        return text.toString();
    }
}

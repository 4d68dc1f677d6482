package arcomat.source;

import java.util.List;

/**
 * A safe repair.
 *
 * @param title what the edits do, in the imperative
 * @param edits replacements that do not overlap
 */
public record Fix(String title, List<TextEdit> edits) {
    public Fix {
        edits = List.copyOf(edits);
    }

    public static Fix replace(String title, Span span, String text) {
        return new Fix(title, List.of(new TextEdit(span, text)));
    }

    /** Replaces the text of a span. */
    public record TextEdit(Span span, String text) {}
}

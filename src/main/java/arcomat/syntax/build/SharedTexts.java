package arcomat.syntax.build;

import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.HashMap;
import java.util.Map;

/**
 * Of one file, what its nodes share. Trees of large models live long, so what is equal is kept
 * once: the texts of names and literals, and the spans of nodes around a sole child.
 */
final class SharedTexts {
    private final SourceFile file;
    private final Map<String, String> texts = new HashMap<>();
    private Span latest;

    SharedTexts(SourceFile file) {
        this.file = file;
        this.latest = file.span(0, 0);
    }

    Span whole() {
        return file.span(0, file.text().length());
    }

    Span span(int start, int end) {
        if (latest.start() != start || latest.end() != end) {
            latest = file.span(start, end);
        }
        return latest;
    }

    String text(Span span) {
        String text = span.text();
        String known = texts.putIfAbsent(text, text);
        return known == null ? text : known;
    }
}

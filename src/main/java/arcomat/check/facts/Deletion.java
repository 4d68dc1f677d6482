package arcomat.check.facts;

import arcomat.source.Fix;
import arcomat.source.Span;
import arcomat.tree.Node;

/** Fixes that take something away and leave no empty line behind. */
public final class Deletion {
    private Deletion() {}

    /** Deletes a node, and its line if nothing else stands on it. */
    public static Fix ofLine(String title, Node node) {
        Span span = node.span();
        String text = span.file().text();
        int start = span.start();
        while (start > 0 && isBlank(text.charAt(start - 1))) {
            start--;
        }
        int end = span.end();
        while (end < text.length() && isBlank(text.charAt(end))) {
            end++;
        }
        boolean alone =
                (start == 0 || text.charAt(start - 1) == '\n')
                        && (end == text.length() || isLineBreak(text.charAt(end)));
        if (!alone) {
            return Fix.replace(title, span, "");
        }
        if (text.startsWith("\r\n", end)) {
            end += 2;
        } else if (end < text.length()) {
            end++;
        }
        return Fix.replace(title, new Span(span.file(), start, end), "");
    }

    private static boolean isBlank(char c) {
        return c == ' ' || c == '\t';
    }

    private static boolean isLineBreak(char c) {
        return c == '\n' || c == '\r';
    }
}

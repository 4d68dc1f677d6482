package arcomat.editor.text;

import arcomat.source.SourceFile;

import org.eclipse.lsp4j.TextEdit;

import java.util.ArrayList;
import java.util.List;

/**
 * From a text to another one that differs from it in white space only, by the smallest edits, so
 * that the cursor, marks and folds of an editor stay where they are.
 */
public final class LayoutEdits {
    private LayoutEdits() {}

    /** Returns edits that do not overlap, in the order of the text. */
    public static List<TextEdit> of(SourceFile before, String after) {
        String text = before.text();
        List<TextEdit> edits = new ArrayList<>();
        int old = 0;
        int fresh = 0;
        while (old < text.length() || fresh < after.length()) {
            int oldEnd = spaceEnd(text, old);
            int freshEnd = spaceEnd(after, fresh);
            String space = after.substring(fresh, freshEnd);
            if (!text.substring(old, oldEnd).equals(space)) {
                edits.add(new TextEdit(Positions.range(before.span(old, oldEnd)), space));
            }
            if (letter(text, oldEnd) != letter(after, freshEnd)) {
                throw new IllegalArgumentException("the texts differ in more than white space");
            }
            old = Math.min(oldEnd + 1, text.length());
            fresh = Math.min(freshEnd + 1, after.length());
        }
        return edits;
    }

    /** A letter; behind the end, none that a text contains. */
    private static int letter(String text, int at) {
        return at < text.length() ? text.charAt(at) : -1;
    }

    private static int spaceEnd(String text, int start) {
        int end = start;
        while (end < text.length() && Character.isWhitespace(text.charAt(end))) {
            end++;
        }
        return end;
    }
}

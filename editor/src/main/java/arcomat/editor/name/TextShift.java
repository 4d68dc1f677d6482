package arcomat.editor.name;

import arcomat.source.Fix.TextEdit;

import java.util.Comparator;
import java.util.List;

/** Edits of one text, and where its places are after them. */
record TextShift(List<TextEdit> edits) {
    static final TextShift NONE = new TextShift(List.of());

    TextShift {
        edits =
                edits.stream()
                        .sorted(Comparator.comparingInt(edit -> edit.span().start()))
                        .toList();
    }

    /** Where an offset is that is at the beginning of a word or outside of all edits. */
    int offset(int before) {
        int offset = before;
        for (TextEdit edit : edits) {
            if (edit.span().end() <= before) {
                offset += edit.text().length() - (edit.span().end() - edit.span().start());
            }
        }
        return offset;
    }

    String applied(String text) {
        StringBuilder after = new StringBuilder();
        int at = 0;
        for (TextEdit edit : edits) {
            after.append(text, at, edit.span().start()).append(edit.text());
            at = edit.span().end();
        }
        return after.append(text, at, text.length()).toString();
    }
}

package arcomat.editor.answer;

import arcomat.editor.text.LayoutEdits;
import arcomat.editor.text.Positions;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.Formatter;

import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextEdit;

import java.util.List;

/** What brings a file into canonical form; nothing where it has syntax errors. */
public final class CanonicalLayout {
    private CanonicalLayout() {}

    public static List<TextEdit> of(SourceFile file) {
        return Formatter.format(file)
                .text()
                .map(text -> LayoutEdits.of(file, text))
                .orElse(List.of());
    }

    /** The same for a part: as much of it as lies in that. */
    public static List<TextEdit> in(SourceFile file, Range range) {
        Span wanted = Positions.span(file, range);
        return of(file).stream()
                .filter(edit -> wanted.isAround(Positions.span(file, edit.getRange())))
                .toList();
    }
}

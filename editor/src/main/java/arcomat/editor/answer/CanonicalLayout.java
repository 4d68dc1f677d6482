package arcomat.editor.answer;

import arcomat.editor.desk.View;
import arcomat.editor.text.LayoutEdits;
import arcomat.editor.text.Positions;
import arcomat.pipeline.guest.GuestLayout;
import arcomat.source.Span;

import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextEdit;

import java.util.List;

/** What brings a file into canonical form; nothing where it has syntax errors. */
public final class CanonicalLayout {
    private CanonicalLayout() {}

    public static List<TextEdit> of(View view) {
        return new GuestLayout(view.models().guests())
                .format(view.file())
                .text()
                .map(text -> LayoutEdits.of(view.file(), text))
                .orElse(List.of());
    }

    /** The same for a part: as much of it as lies in that. */
    public static List<TextEdit> in(View view, Range range) {
        Span wanted = Positions.span(view.file(), range);
        return of(view).stream()
                .filter(edit -> wanted.isAround(Positions.span(view.file(), edit.getRange())))
                .toList();
    }
}

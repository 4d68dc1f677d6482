package arcomat.editor.answer.shape;

import arcomat.editor.desk.View;
import arcomat.editor.text.Positions;
import arcomat.source.Span;
import arcomat.syntax.Regions;

import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.SelectionRange;

import java.util.List;

/** What is selected as a selection grows: a word, what it is a part of, and so on. */
public final class Selections {
    private Selections() {}

    /** Returns the innermost range for each place, with those around it. */
    public static List<SelectionRange> at(View view, List<Position> places) {
        return places.stream().map(place -> at(view, view.offset(place))).toList();
    }

    private static SelectionRange at(View view, int offset) {
        List<Span> around = Regions.around(view.file(), offset);
        SelectionRange range = new SelectionRange(Positions.all(view.file()), null);
        for (int i = around.size() - 2; i >= 0; i--) {
            range = new SelectionRange(Positions.range(around.get(i)), range);
        }
        return range;
    }
}

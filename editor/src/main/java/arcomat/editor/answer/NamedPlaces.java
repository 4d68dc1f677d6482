package arcomat.editor.answer;

import arcomat.editor.desk.View;
import arcomat.editor.name.Mentions;
import arcomat.editor.text.Positions;
import arcomat.source.Span;
import arcomat.symbols.occurrences.Occurrence;
import arcomat.symbols.occurrences.Occurrence.Role;
import arcomat.symbols.occurrences.Referent;

import org.eclipse.lsp4j.DocumentHighlight;
import org.eclipse.lsp4j.DocumentHighlightKind;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.Position;

import java.util.ArrayList;
import java.util.List;

/** All places that name the same as the one under the cursor. */
public final class NamedPlaces {
    private NamedPlaces() {}

    /**
     * In all files.
     *
     * @param declaration whether the place of the declaration is wanted as well
     */
    public static List<Location> references(View view, Position position, boolean declaration) {
        return Mentions.at(view, view.offset(position))
                .map(Occurrence::referent)
                .map(referent -> places(view, referent, declaration))
                .orElse(List.of());
    }

    private static List<Location> places(View view, Referent referent, boolean declaration) {
        List<Span> places = new ArrayList<>();
        if (declaration && referent.isImplicit()) {
            referent.declaration().ifPresent(places::add);
        }
        Mentions.of(view.models(), referent).stream()
                .filter(each -> declaration || !each.isDeclaration())
                .map(Occurrence::span)
                .forEach(places::add);
        return places.stream().map(view::location).toList();
    }

    /** In the same file, with what each place does. */
    public static List<DocumentHighlight> inFile(View view, Position position) {
        return Mentions.at(view, view.offset(position))
                .map(Occurrence::referent)
                .map(
                        referent ->
                                Mentions.in(view).stream()
                                        .filter(each -> each.referent().equals(referent))
                                        .map(NamedPlaces::highlight)
                                        .toList())
                .orElse(List.of());
    }

    private static DocumentHighlight highlight(Occurrence occurrence) {
        return new DocumentHighlight(Positions.range(occurrence.span()), kind(occurrence.role()));
    }

    private static DocumentHighlightKind kind(Role role) {
        return switch (role) {
            case READS -> DocumentHighlightKind.Read;
            case WRITES -> DocumentHighlightKind.Write;
            case DECLARES, REFERS -> DocumentHighlightKind.Text;
        };
    }
}

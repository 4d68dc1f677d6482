package arcomat.editor.answer.shape;

import arcomat.editor.text.Positions;
import arcomat.source.Span;
import arcomat.symbols.occurrences.Referent;

import org.eclipse.lsp4j.DocumentSymbol;
import org.eclipse.lsp4j.SymbolKind;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * A line of an outline with those below it.
 *
 * @param whole all of the text that declares it
 * @param place its name, in that text; what is written instead where there is no name
 * @param detail in a few words what it is; may be empty
 */
record OutlineEntry(
        String name,
        SymbolKind kind,
        Span whole,
        Span place,
        String detail,
        List<OutlineEntry> inside) {

    /** Of what is declared by a text of its own. */
    static OutlineEntry of(Referent referent, Span whole, Stream<OutlineEntry> inside) {
        return new OutlineEntry(
                referent.name(),
                SymbolKinds.of(referent),
                whole,
                referent.declaration().orElseThrow(),
                referent.match(new ShortDescription()),
                inTextOrder(inside));
    }

    /** Of what is declared by its name, in a list of others. */
    static OutlineEntry of(Referent referent) {
        return of(referent, referent.declaration().orElseThrow(), Stream.empty());
    }

    static List<OutlineEntry> inTextOrder(Stream<OutlineEntry> entries) {
        return entries.sorted(Comparator.comparingInt(each -> each.place().start())).toList();
    }

    DocumentSymbol symbol() {
        return new DocumentSymbol(
                name,
                kind,
                Positions.range(whole),
                Positions.range(place),
                detail,
                inside.stream().map(OutlineEntry::symbol).toList());
    }
}

package arcomat.translate;

import arcomat.guest.Meaning.Piece;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;

/**
 * What a language has written, as one text, and where each part of it comes from.
 *
 * @param pieces by the offset in the text at which they begin
 */
public record TranslatedText(SourceFile file, NavigableMap<Integer, Piece> pieces) {
    /**
     * @param written at least one piece
     */
    public static TranslatedText of(String path, List<Piece> written) {
        StringBuilder text = new StringBuilder();
        NavigableMap<Integer, Piece> pieces = new TreeMap<>();
        for (Piece piece : written) {
            if (pieces.isEmpty() || !piece.text().isEmpty()) {
                pieces.put(text.length(), piece);
            }
            text.append(piece.text());
        }
        return new TranslatedText(new SourceFile(path, text.toString()), pieces);
    }

    /** The piece in which a part of the text begins. */
    public Piece beginning(Span part) {
        return pieces.floorEntry(part.start()).getValue();
    }

    /**
     * With what a text has no words for: languages say it beside.
     *
     * @param written with places in this text
     * @param placed the same, with those that it comes from
     */
    public Automaton ordered(Automaton written, Automaton placed) {
        List<AutomatonElement> elements = new ArrayList<>();
        for (int i = 0; i < placed.elements().size(); i++) {
            elements.add(ordered(written.elements().get(i), placed.elements().get(i)));
        }
        return new Automaton(placed.span(), placed.stereotypes(), placed.name(), elements);
    }

    private AutomatonElement ordered(AutomatonElement written, AutomatonElement placed) {
        if (placed instanceof AutomatonElement.Transition transition) {
            Piece beginning = beginning(written.span());
            return transition.ordered(beginning.rank(), beginning.turn());
        }
        if (placed instanceof AutomatonElement.States states
                && written instanceof AutomatonElement.States before) {
            List<AutomatonElement.State> all = new ArrayList<>();
            for (int i = 0; i < states.states().size(); i++) {
                Piece beginning = beginning(before.states().get(i).span());
                all.add(states.states().get(i).within(beginning.within()));
            }
            return new AutomatonElement.States(states.span(), all);
        }
        return placed;
    }

    /** What a part of the text stands for: exactly, where it was taken over letter by letter. */
    public Span origin(Span part) {
        Map.Entry<Integer, Piece> first = pieces.floorEntry(part.start());
        int last = pieces.floorKey(Math.max(part.start(), part.end() - 1));
        if (first.getKey() == last) {
            return origin(first.getValue(), part.start() - first.getKey(), part);
        }
        int start = Integer.MAX_VALUE;
        int end = 0;
        for (Piece piece : pieces.subMap(first.getKey(), true, last, true).values()) {
            Span place = piece.element().orElse(piece.place());
            start = Math.min(start, place.start());
            end = Math.max(end, place.end());
        }
        return new Span(first.getValue().place().file(), start, end);
    }

    private static Span origin(Piece piece, int offset, Span part) {
        Span place = piece.place();
        if (!isTakenOver(piece)) {
            return place;
        }
        int start = place.start() + offset;
        return new Span(place.file(), start, start + part.end() - part.start());
    }

    /** The places whose text was taken over letter by letter. */
    public List<Span> takenOver() {
        return pieces.values().stream()
                .filter(TranslatedText::isTakenOver)
                .map(Piece::place)
                .toList();
    }

    /** Whether a piece stands in the language's text as it stands in this one. */
    public static boolean isTakenOver(Piece piece) {
        return piece.place().text().equals(piece.text());
    }
}

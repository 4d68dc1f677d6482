package arcomat.pipeline.guest;

import arcomat.guest.Meaning.Piece;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;

/**
 * What a guest has written, as one text, and where each part of it comes from.
 *
 * @param pieces by the offset in the text at which they begin
 */
record TranslatedText(SourceFile file, NavigableMap<Integer, Piece> pieces) {
    /**
     * @param written at least one piece
     */
    static TranslatedText of(String path, List<Piece> written) {
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

    /** The rank of a transition: that of the piece in which it begins. */
    int rank(Span transition) {
        return pieces.floorEntry(transition.start()).getValue().rank();
    }

    /** What a part of the text stands for: exactly, where it was taken over letter by letter. */
    Span origin(Span part) {
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
        if (!place.text().equals(piece.text())) {
            return place;
        }
        int start = place.start() + offset;
        return new Span(place.file(), start, start + part.end() - part.start());
    }
}

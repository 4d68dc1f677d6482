package arcomat.pipeline.guest;

import arcomat.guest.Meaning.Piece;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;

/**
 * What a guest has written, as one text, and where each part of it comes from.
 *
 * @param starts of the pieces in the text
 */
record TranslatedText(SourceFile file, List<Piece> pieces, List<Integer> starts) {
    /**
     * @param pieces at least one
     */
    static TranslatedText of(String path, List<Piece> pieces) {
        StringBuilder text = new StringBuilder();
        List<Integer> starts = new ArrayList<>();
        for (Piece piece : pieces) {
            starts.add(text.length());
            text.append(piece.text());
        }
        return new TranslatedText(new SourceFile(path, text.toString()), pieces, starts);
    }

    /** What a part of the text stands for: exactly, where it was taken over letter by letter. */
    Span origin(Span part) {
        int first = piece(part.start());
        int last = piece(Math.max(part.start(), part.end() - 1));
        Span from = pieces.get(first).place();
        if (first == last) {
            int offset = part.start() - starts.get(first);
            return isTakenOver(pieces.get(first))
                    ? new Span(
                            from.file(),
                            from.start() + offset,
                            from.start() + offset + part.end() - part.start())
                    : from;
        }
        int start = Integer.MAX_VALUE;
        int end = 0;
        for (Piece piece : pieces.subList(first, last + 1)) {
            start = Math.min(start, piece.place().start());
            end = Math.max(end, piece.place().end());
        }
        return new Span(from.file(), start, end);
    }

    private static boolean isTakenOver(Piece piece) {
        return piece.place().text().equals(piece.text());
    }

    /** The last piece that begins at an offset or before it, and is not empty. */
    private int piece(int offset) {
        int found = 0;
        for (int i = 0; i < starts.size(); i++) {
            if (starts.get(i) <= offset && !pieces.get(i).text().isEmpty()) {
                found = i;
            }
        }
        return found;
    }
}

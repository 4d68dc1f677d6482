package arcomat.pipeline.guest;

import arcomat.guest.Meaning.Piece;
import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.translate.TranslatedText;

import java.util.Locale;
import java.util.Optional;

/**
 * A syntax error in what a guest has taken over letter by letter, as a guard that is Arcomat's own
 * expression: whoever wrote it is told, and not whoever wrote the guest.
 *
 * @param part of the text of the behaviour that cannot be read with it
 */
record TakenOver(Span place, String message, Span part) {

    /**
     * Nothing where the guest's own words are what cannot be read. What is unfinished is told where
     * it ends: what follows are the guest's words.
     */
    static Optional<TakenOver> of(Diagnostic finding, TranslatedText text) {
        Piece here = text.beginning(finding.span());
        if (TranslatedText.isTakenOver(here)) {
            return Optional.of(in(here, text.origin(finding.span()), inside(finding.message())));
        }
        String before = text.file().text().substring(0, finding.span().start()).stripTrailing();
        if (before.isEmpty()) {
            return Optional.empty();
        }
        Piece last = text.beginning(text.file().span(before.length() - 1, before.length()));
        return TranslatedText.isTakenOver(last)
                ? Optional.of(in(last, last.place(), behind(last, finding.message())))
                : Optional.empty();
    }

    private static TakenOver in(Piece piece, Span place, String message) {
        return new TakenOver(place, message, piece.element().orElse(piece.place()));
    }

    private static String inside(String message) {
        return message.substring(0, 1).toLowerCase(Locale.ROOT) + withoutStop(message.substring(1));
    }

    private static String behind(Piece last, String message) {
        int expected = message.indexOf("Expected ");
        return "'"
                + last.text().strip()
                + "' ends too early"
                + (expected < 0
                        ? "; write all of it"
                        : ". " + withoutStop(message.substring(expected)));
    }

    private static String withoutStop(String message) {
        return message.endsWith(".") ? message.substring(0, message.length() - 1) : message;
    }
}

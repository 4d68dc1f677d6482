package statemachine;

import arcomat.guest.Meaning;
import arcomat.source.Span;

/** A text does not go on as a state machine could. */
final class UnreadableText extends Exception {
    private static final long serialVersionUID = 1;

    private final Mistake mistake;
    private final transient Span place;
    private final String reason;

    UnreadableText(Span place, String reason) {
        this(Mistake.UNREADABLE, place, reason);
    }

    UnreadableText(Mistake mistake, Span place, String reason) {
        super(reason);
        this.mistake = mistake;
        this.place = place;
        this.reason = reason;
    }

    void tell(Meaning meaning) {
        mistake.tell(meaning, place, reason);
    }
}

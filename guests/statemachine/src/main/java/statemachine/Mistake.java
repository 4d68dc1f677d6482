package statemachine;

import arcomat.guest.Meaning;
import arcomat.source.Span;

import java.util.Locale;

/** What may be wrong with a state machine; {@code explain/STMnnnn.md} says why it matters. */
enum Mistake {
    UNREADABLE("STM0001"),
    NAMED_TWICE("STM0002"),
    UNKNOWN_STATE("STM0003"),
    NO_BEGINNING("STM0004"),
    SAID_TWICE("STM0005"),
    NO_ASSIGNMENT("STM0006"),
    WRITTEN_TWICE("STM0007"),
    READ_BACK("STM0008"),
    NOTHING_TO_REMEMBER("STM0009"),
    TOO_LARGE("STM0010");

    private final String code;

    Mistake(String code) {
        this.code = code;
    }

    String code() {
        return code;
    }

    void tell(Meaning meaning, Span place, String message, Object... values) {
        String all = values.length == 0 ? message : String.format(Locale.ROOT, message, values);
        meaning.problem(code, place, all);
    }
}

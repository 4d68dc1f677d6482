package arcomat.analysis.bits;

import arcomat.model.Value;
import arcomat.semantics.value.GivenUp;

import java.util.HashMap;
import java.util.Map;

/**
 * Texts as numbers, of which nothing is asked but whether they are the same. There are more numbers
 * than texts that a question mentions and ports that may carry others: so whatever is possible with
 * texts, is possible with these numbers (data independence: Wolper, "Expressing interesting
 * properties of programs in propositional temporal logic", POPL 1986).
 */
final class TextCodes {
    /** The largest number. */
    static final long MOST = 0xFFFF;

    /** What is left is for ports. */
    private static final int MOST_TEXTS = 0x8000;

    private final Map<String, Long> codes = new HashMap<>();
    private final Map<Long, String> texts = new HashMap<>();
    private long next;
    private int made;

    /**
     * @throws GivenUp where there are too many texts
     */
    long code(Value value) {
        if (!(value instanceof Value.StringValue text)) {
            throw new GivenUp(value + " is no String");
        }
        Long known = codes.get(text.value());
        if (known != null) {
            return known;
        }
        while (texts.containsKey(next)) {
            next++;
        }
        bind(text.value(), next);
        return next;
    }

    /** The text of a number: for one that stands for none so far, one that nobody has mentioned. */
    Value text(long code) {
        String known = texts.get(code);
        if (known == null) {
            known = unmentioned();
            bind(known, code);
        }
        return new Value.StringValue(known);
    }

    private void bind(String text, long code) {
        if (codes.size() >= MOST_TEXTS) {
            throw new GivenUp("too many texts");
        }
        codes.put(text, code);
        texts.put(code, text);
    }

    private String unmentioned() {
        String text;
        do {
            text = "text " + ++made;
        } while (codes.containsKey(text));
        return text;
    }
}

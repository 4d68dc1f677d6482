package arcomat.analysis.mona;

import arcomat.analysis.mona.Bits.Condition;
import arcomat.analysis.mona.InclusionProblem.NotForMona;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.SmallType;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The messages of a port in binary: code 0 is no message, k is the k-th message of the type. Each
 * bit is a set of slices, those in which it is 1.
 *
 * @param total whether code 0 cannot occur
 * @param messages in their natural order
 */
record PortTrack(Port port, boolean total, List<Value> messages) {

    /**
     * @throws NotForMona where the type has too many messages
     */
    static PortTrack of(Port port) {
        List<Value> messages =
                SmallType.values(port.type())
                        .orElseThrow(
                                () ->
                                        new NotForMona(
                                                "port '%s' carries %s, which has more than %d values; give it a range"
                                                        .formatted(
                                                                port.name(),
                                                                port.type().name(),
                                                                SmallType.MOST)));
        return new PortTrack(port, port.total() && port.isInput(), messages);
    }

    /** What is true of the codes at every position. */
    List<Condition> valid(String position) {
        List<Condition> valid = new ArrayList<>(bits().isAtMost(messages.size(), position));
        if (total) {
            valid.add(Condition.not(bits().is(0, position)));
        }
        return valid;
    }

    /** Names of the bits, the lowest first. None of them can be a word of MONA's. */
    Bits bits() {
        return Bits.named(escaped(port.name()) + "_", messages.size() + 1);
    }

    /** Names of models may have letters that MONA does not know; its own may have an apostrophe. */
    private static String escaped(String name) {
        StringBuilder escaped = new StringBuilder();
        for (char c : name.toCharArray()) {
            boolean plain = c < 128 && (Character.isLetterOrDigit(c) || c == '_');
            escaped.append(plain ? String.valueOf(c) : "'" + Integer.toHexString(c) + "'");
        }
        return escaped.toString();
    }

    /** The code of a message; of no message where it is null. */
    int code(Value message) {
        return message == null ? 0 : messages.indexOf(message) + 1;
    }

    /** The code of what is sent; of no message where some message is left open. */
    int codeOf(Sent sent) {
        return sent instanceof Sent.Messages messages && !messages.values().isEmpty()
                ? code(messages.values().get(0))
                : 0;
    }

    Optional<Value> message(int code) {
        return code == 0 ? Optional.empty() : Optional.of(messages.get(code - 1));
    }

    /** All codes that occur. */
    Set<Integer> codes() {
        Set<Integer> codes = new LinkedHashSet<>();
        for (int code = total ? 1 : 0; code <= messages.size(); code++) {
            codes.add(code);
        }
        return codes;
    }

    /** Every code with its meaning. */
    String legend() {
        List<String> words = new ArrayList<>();
        for (int code : codes()) {
            words.add(code + " " + message(code).map(Value::toString).orElse("--"));
        }
        if (words.size() > 12) {
            words.subList(8, words.size() - 2).clear();
            words.add(8, "..");
        }
        return port.name() + ": " + String.join(", ", words);
    }
}

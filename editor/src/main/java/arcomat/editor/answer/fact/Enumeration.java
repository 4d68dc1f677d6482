package arcomat.editor.answer.fact;

import java.util.List;
import java.util.stream.Collectors;

/** Several things in one sentence, and not more of them than somebody reads. */
final class Enumeration {
    private static final int MOST = 5;

    private Enumeration() {}

    static String of(List<String> things) {
        String shown = things.stream().limit(MOST).collect(Collectors.joining(", "));
        return things.size() <= MOST ? shown : shown + " and " + (things.size() - MOST) + " more";
    }
}

package arcomat.analysis;

import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Moment;
import arcomat.model.Letter;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** Verdicts on one line. */
public final class Verdicts {
    private Verdicts() {}

    /** As much of a verdict as somebody expected: {@code fails {}/{cmd = fwd}}. */
    public static String text(Verdict verdict, String expected) {
        String answer = verdict.answer().name().toLowerCase(Locale.ROOT);
        if (expected.equals(answer)) {
            return answer;
        }
        if (expected.startsWith(answer + " says ")) {
            return answer + " says " + sentences(verdict);
        }
        if (expected.startsWith("fails {") && verdict.answer() == Answer.FAILS) {
            return answer + " " + trace(verdict.trace());
        }
        String notes = String.join("; ", verdict.notes());
        String more =
                switch (verdict.answer()) {
                    case HOLDS -> simulation(verdict) + "; " + notes + explored(verdict);
                    case FAILS -> verdict.reason() + ", " + (notes.isEmpty() ? "not late" : notes);
                    case UNKNOWN -> verdict.reason() + "; " + notes;
                };
        String wanted = expected.substring(Math.min(expected.length(), answer.length() + 1));
        return answer + " " + (more.contains(wanted) ? wanted : more);
    }

    private static String sentences(Verdict verdict) {
        return verdict.explanation().stream()
                .map(Sentence::text)
                .collect(Collectors.joining(" | "));
    }

    private static String explored(Verdict verdict) {
        return "; %d pairs of %d and %d configurations"
                .formatted(
                        verdict.explored().pairs(),
                        verdict.explored().left().orElseThrow(),
                        verdict.explored().right());
    }

    private static String simulation(Verdict verdict) {
        return verdict.simulation()
                .map(s -> s ? "simulates" : "does not simulate")
                .orElse("may simulate");
    }

    public static String trace(List<Moment> trace) {
        return trace.stream()
                .map(
                        moment ->
                                letter(moment.input())
                                        + "/"
                                        + (moment.error() ? error(moment) : sent(moment.outputs())))
                .collect(Collectors.joining(" "));
    }

    /** With what earlier reactions still show. */
    private static String error(Moment moment) {
        return (moment.outputs().isEmpty() ? "" : sent(moment.outputs())) + "error";
    }

    private static String letter(Letter letter) {
        return letter.messages().entrySet().stream()
                .map(e -> e.getKey() + " = " + e.getValue().get(0))
                .collect(Collectors.joining(", ", "{", "}"));
    }

    private static String sent(Map<String, Sent> sent) {
        List<String> words = new ArrayList<>();
        sent.forEach(
                (port, what) -> {
                    if (!what.equals(Sent.SILENCE)) {
                        words.add(port + " = " + (what instanceof Sent.Messages ? what : "*"));
                    }
                });
        return "{" + String.join(", ", words) + "}";
    }
}

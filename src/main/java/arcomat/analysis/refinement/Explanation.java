package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.product.Comparison.Allowed;
import arcomat.analysis.search.product.Comparison.Forbidden;
import arcomat.model.Trace;
import arcomat.semantics.expression.Sent;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Says why a refinement fails: what the left side did last, and what the right one would allow. */
public final class Explanation {
    private Explanation() {}

    static List<Sentence> of(Promise left, Promise right, Forbidden forbidden, int number) {
        List<Sentence> sentences = new ArrayList<>();
        boolean beginning = forbidden.left().isEmpty();
        String when = beginning ? "At the start" : "With input %d".formatted(number);
        sentences.add(
                new Sentence(
                        "%s, %s %s%s"
                                .formatted(
                                        when,
                                        left.title(),
                                        forbidden
                                                .error()
                                                .map(
                                                        error ->
                                                                "ends in an "
                                                                        + error
                                                                        + still(forbidden.sent()))
                                                .orElse("sends " + words(forbidden.sent())),
                                        by(left, forbidden.left(), forbidden.causes())),
                        place(left, forbidden.causes())));
        for (Allowed allowed : forbidden.right()) {
            sentences.add(
                    new Sentence(
                            "%s allows %s%s"
                                    .formatted(
                                            right.title(),
                                            allowed(allowed, forbidden),
                                            by(right, allowed.configuration(), allowed.causes())),
                            place(right, allowed.causes())));
        }
        if (forbidden.right().isEmpty()) {
            sentences.add(
                    new Sentence(
                            right.title() + " allows nothing any more",
                            Optional.of(right.component().span())));
        }
        return sentences;
    }

    /** What earlier reactions show in the slice in which a run ends. */
    private static String still(Map<String, Sent> sent) {
        return sent.isEmpty() ? "" : " in a slice that still shows " + words(sent);
    }

    private static String allowed(Allowed allowed, Forbidden forbidden) {
        boolean errorForbidden = forbidden.error().isPresent();
        boolean onlyErrors = forbidden.right().stream().allMatch(Allowed::error);
        if (allowed.error()) {
            boolean showsLess =
                    errorForbidden && allowed.sent().isEmpty() && !forbidden.sent().isEmpty();
            return (onlyErrors ? "only an error" : "an error")
                    + (showsLess ? " in a slice that shows nothing" : still(allowed.sent()));
        }
        String words = words(allowed.sent());
        return switch (words) {
            case "nothing" -> silence(allowed.sent());
            case "anything" -> errorForbidden ? "any output, but no error" : words;
            default -> words;
        };
    }

    /** Ports that are left open are only mentioned where all are. */
    public static String words(Map<String, Sent> sent) {
        if (!sent.isEmpty() && sent.values().stream().allMatch(Sent.Anything.class::isInstance)) {
            return "anything";
        }
        String words =
                sent.entrySet().stream()
                        .filter(each -> !each.getValue().equals(Sent.SILENCE))
                        .filter(each -> !(each.getValue() instanceof Sent.Anything))
                        .map(each -> each.getKey() + " = " + each.getValue())
                        .collect(Collectors.joining(", "));
        return words.isEmpty() ? "nothing" : words;
    }

    /** What is allowed where no message has to be sent, and not everything is left open. */
    public static String silence(Map<String, Sent> sent) {
        List<String> silent =
                sent.entrySet().stream()
                        .filter(each -> each.getValue().equals(Sent.SILENCE))
                        .map(Map.Entry::getKey)
                        .toList();
        return silent.size() == sent.size()
                ? "only silence"
                : "only silence on " + String.join(", ", silent);
    }

    public static String by(Promise promise, String before, List<Trace.Cause> causes) {
        if (before.isEmpty()) {
            return "";
        }
        List<String> words = new Causes(promise).words(causes);
        return words.isEmpty() ? "" : ", in " + before + ": " + String.join("; ", words);
    }

    public static Optional<Span> place(Promise promise, List<Trace.Cause> causes) {
        for (Trace.Cause cause : causes) {
            if (cause instanceof Trace.Taken taken && taken.transition().span() != null) {
                return Optional.of(taken.transition().span());
            }
        }
        return promise.automata().isEmpty()
                ? Optional.ofNullable(promise.component().span())
                : Optional.ofNullable(promise.automata().get(0).span());
    }
}
